// @ts-check
import { useEffect, useRef } from 'preact/hooks';

/**
 * Keeps a set of the styles on the wall that are in sight.
 * @param {Set<string>} visible
 * @param {readonly import('../../state/explorer.js').Item[]} shown
 * @returns {import('preact').RefObject<HTMLUListElement | null>} for the wall, whose items name their style in `data-style`
 */
export function useVisible(visible, shown) {
  const wall = useRef(/** @type {HTMLUListElement | null} */ (null));
  useEffect(() => {
    const root = wall.current;
    if (!root) return undefined;
    const observer = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        const { style } = /** @type {HTMLElement} */ (target).dataset;
        if (style !== undefined) visible[isIntersecting ? 'add' : 'delete'](style);
      }
    }, { root });
    visible.clear();
    for (const item of root.children) observer.observe(item);
    return () => observer.disconnect();
  }, [shown.length, shown[0]?.style.id]);
  return wall;
}
