import { useEffect, useRef } from 'preact/hooks';
import type { Item } from './explorer.ts';
import type { RefObject } from 'preact';

/**
 * Keeps a set of the styles on the wall that are in sight.
 * @returns for the wall, whose items name their style in `data-style`
 */
export function useVisible(visible: Set<string>, shown: readonly Item[]): RefObject<HTMLUListElement | null> {
  const wall = useRef(null as HTMLUListElement | null);
  useEffect(() => {
    const root = wall.current;
    if (!root) return undefined;
    const observer = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) {
          const { style } = (target as HTMLElement).dataset;
          if (style !== undefined) visible[isIntersecting ? 'add' : 'delete'](style);
        }
      },
      { root },
    );
    visible.clear();
    for (const item of root.children) observer.observe(item);
    return () => observer.disconnect();
  }, [shown.length, shown[0]?.style.id]);
  return wall;
}
