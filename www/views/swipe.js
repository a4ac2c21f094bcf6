// @ts-check
/**
 * A horizontal swipe over the page by touch: it follows the finger, and past a quarter of the width turns the page.
 */

import { useRef } from 'preact/hooks';

/** The part of the width that a swipe must cover. */
const ENOUGH = 0.22;
/** Pixels before a touch counts as a swipe. */
const SLACK = 12;

/**
 * @param {{ current: HTMLElement | null }} moved
 * @param {{ forth: () => void, back: () => void }} deeds
 */
export function useSwipe(moved, { forth, back }) {
  const from = useRef(/** @type {{ id: number, x: number, y: number } | null} */ (null));

  /** @param {number} x */
  function shift(x) {
    if (moved.current) moved.current.style.translate = x === 0 ? '' : `${x}px`;
  }

  return {
    /** @param {PointerEvent} event */
    onPointerDown: ({ pointerType, pointerId, clientX, clientY, isPrimary }) => {
      from.current = pointerType === 'touch' && isPrimary ? { id: pointerId, x: clientX, y: clientY } : null;
      // A second finger means something else.
      if (!isPrimary) shift(0);
    },
    /** @param {PointerEvent} event */
    onPointerMove: ({ pointerId, clientX, clientY }) => {
      if (from.current?.id !== pointerId) return;
      const x = clientX - from.current.x;
      if (Math.abs(x) > SLACK && Math.abs(x) > Math.abs(clientY - from.current.y)) shift(x * 0.6);
    },
    /** @param {PointerEvent} event */
    onPointerUp: ({ pointerId, clientX, clientY }) => {
      if (from.current?.id !== pointerId) return;
      const x = clientX - from.current.x;
      const far = Math.abs(x) > ENOUGH * globalThis.innerWidth && Math.abs(x) > 2 * Math.abs(clientY - from.current.y);
      from.current = null;
      shift(0);
      if (far) (x < 0 ? forth : back)();
    },
    onPointerCancel: () => {
      from.current = null;
      shift(0);
    },
  };
}
