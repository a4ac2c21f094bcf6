/**
 * A horizontal swipe over the page by touch: it follows the finger, and past a quarter of the width turns the page.
 */

import { useRef } from 'preact/hooks';

/** The part of the width that a swipe must cover. */
const ENOUGH = 0.22;
/** Pixels before a touch counts as a swipe. */
const SLACK = 12;

export function useSwipe(
  moved: { current: HTMLElement | null },
  { forth, back }: { forth: () => void; back: () => void },
) {
  const from = useRef(null as { id: number; x: number; y: number } | null);

  function shift(x: number) {
    if (moved.current) moved.current.style.translate = x === 0 ? '' : `${x}px`;
  }

  return {
    onPointerDown: ({ pointerType, pointerId, clientX, clientY, isPrimary }: PointerEvent) => {
      from.current = pointerType === 'touch' && isPrimary ? { id: pointerId, x: clientX, y: clientY } : null;
      // A second finger starts another gesture.
      if (!isPrimary) shift(0);
    },
    onPointerMove: ({ pointerId, clientX, clientY }: PointerEvent) => {
      if (from.current?.id !== pointerId) return;
      const x = clientX - from.current.x;
      if (Math.abs(x) > SLACK && Math.abs(x) > Math.abs(clientY - from.current.y)) shift(x * 0.6);
    },
    onPointerUp: ({ pointerId, clientX, clientY }: PointerEvent) => {
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
