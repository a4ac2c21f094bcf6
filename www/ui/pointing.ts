/**
 * Detects the choice that the user looks at: under the pointer, with keyboard focus, or with a long press, which does
 * not select it.
 */

import { after } from '../engine/scheduler.ts';

/** Receives the current choice, or null. */
export type Point = (id: string | null, element?: Element) => void;

/** Duration of a long press in milliseconds, and its maximum movement in CSS pixels. */
const HOLD = 400;
const SLACK = 10;

/** @returns handlers for the element of a choice */
export function pointing(id: string, point: Point) {
  return {
    onPointerEnter: ({ pointerType, currentTarget }: Of<PointerEvent>) => {
      if (pointerType !== 'touch') point(id, currentTarget);
    },
    onPointerDown: (event: Of<PointerEvent>) => {
      if (event.pointerType === 'touch' && event.isPrimary) hold(event, id, point);
    },
    onFocus: ({ currentTarget }: Of<FocusEvent>) => {
      if (currentTarget.matches(':focus-visible')) point(id, currentTarget);
    },
  };
}

type Of<T> = T & { currentTarget: HTMLElement };

/**
 * Returns whether a press was too short for a long press of that many milliseconds. While the app is busy, the timer of a
 * long press can end before the app learns that the finger was lifted.
 */
export const isTap = (down: Event, up: Event, hold: number) => up.timeStamp - down.timeStamp < hold;

/** Points at it once the finger has stayed, until it is lifted; then no click follows. */
function hold(down: Of<PointerEvent>, id: string, point: Point) {
  const { clientX, clientY, currentTarget: element } = down;
  const watch = new AbortController();
  const { signal } = watch;
  let held = false;
  const cancel = after(HOLD, () => {
    held = true;
    point(id, element);
  });
  const end = (event: PointerEvent) => {
    cancel();
    watch.abort();
    if (!held) return;
    point(null);
    if (!isTap(down, event, HOLD)) swallowClick(element);
  };
  const move = (event: PointerEvent) => {
    if (!held && Math.hypot(event.clientX - clientX, event.clientY - clientY) > SLACK) end(event);
  };
  window.addEventListener('pointermove', move, { signal });
  window.addEventListener('pointerup', end, { signal });
  window.addEventListener('pointercancel', end, { signal });
  // Suppress the browser's own actions for a long press and the movement after it.
  const ours = (event: Event) => held && event.preventDefault();
  element.addEventListener('touchmove', ours, { signal, passive: false });
  element.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
}

/** The click that a browser makes of the finger that was lifted. */
function swallowClick(element: HTMLElement) {
  const done = new AbortController();
  element.addEventListener(
    'click',
    (event) => {
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    { signal: done.signal, capture: true },
  );
  after(50, () => done.abort());
}
