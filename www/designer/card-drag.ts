/**
 * Cards of the designer that are carried to another place, also in the other layer, and blocks that are carried there
 * from the palette. A mouse drags cards by their headers and blocks by their images. A finger or pen drags cards by
 * their handles, or blocks after a long press, because it scrolls elsewhere. Near an edge the lanes scroll
 * automatically.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { onEscape } from '../ui/on-escape.ts';
import { isTap } from '../ui/pointing.ts';
import { after } from '../engine/scheduler.ts';
import type { Layer, Place } from '../engine/types.ts';

/** A card by its place, or a block of the palette by its id. */
export type Source = { from: Place; block?: undefined } | { from?: undefined; block: string };
/** the dragged item, its insert position, and the position of the pointer */
type Carried = Source & { gap: Place | null; x: number; y: number };
export type CardDrag = ReturnType<typeof useCardDrag>;

/** Tolerance for unsteady hands, in CSS pixels. */
const SLACK = 5;
/** Milliseconds of a long press that lifts a block from the palette. */
const HOLD = 300;
/** Distance from an edge at which the lanes scroll, and maximum speed in CSS pixels per frame. */
const EDGE = 56;
const SPEED = 12;

/** @param onDrop `to`: index among the existing cards */
export function useCardDrag(onDrop: (source: Source, to: Place) => void) {
  const [carried, setCarried] = useState(null as Carried | null);
  /** Cancels the drag. */
  const cancel = useRef(() => {});
  /** Whether a block is off the palette: no finger scrolls then, and no click follows. */
  const lifted = useRef(false);

  useEffect(() => {
    // A listener that is added while the finger is down cannot prevent scrolling.
    const still = (event: TouchEvent) => {
      if (lifted.current && event.cancelable) event.preventDefault();
    };
    const quiet = (event: MouseEvent) => {
      if (!lifted.current) return;
      event.preventDefault();
      event.stopPropagation();
    };
    document.addEventListener('touchmove', still, { passive: false });
    document.addEventListener('click', quiet, { capture: true });
    return () => {
      document.removeEventListener('touchmove', still);
      document.removeEventListener('click', quiet, { capture: true });
    };
  }, []);

  /** @param event on a card's head, or on a block of the palette */
  function take(event: PointerEvent, source: Source) {
    const target = event.target as Element;
    const mouse = event.pointerType === 'mouse';
    const handle = target.closest('.card-handle') !== null;
    if (!event.isPrimary || event.button !== 0 || (!mouse && !handle && source.from)) return;
    const lanes = document.querySelector('.lanes') as HTMLElement;
    // In a small window, the whole designer scrolls.
    const scroller = (
      getComputedStyle(lanes).overflowY === 'visible' ? lanes.closest('.designer') : lanes
    ) as HTMLElement;
    const held = event.currentTarget as HTMLElement;
    const start = { x: event.clientX, y: event.clientY };
    let last = start;
    let gap: Place | null = null;
    let moved = false;
    let frame = 0;
    const needsHold = !mouse && !handle;
    let ready = !needsHold;
    cancel.current();
    const watch = new AbortController();
    const { signal } = watch;

    const point = () => {
      gap = gapAt(lanes, last.x, last.y);
      setCarried({ ...source, gap, ...last });
    };
    const scroll = () => {
      const { top, bottom } = scroller.getBoundingClientRect();
      const into = Math.max(0, last.y - (bottom - EDGE)) - Math.max(0, top + EDGE - last.y);
      if (into !== 0 && gap) {
        scroller.scrollTop += Math.max(-1, Math.min(1, into / EDGE)) * SPEED;
        point();
      }
      frame = requestAnimationFrame(scroll);
    };
    const lift = () => {
      ready = true;
      moved = true;
      lifted.current = true;
      frame = requestAnimationFrame(scroll);
      point();
    };
    const cancelHold = ready ? () => {} : after(HOLD, lift);
    const end = () => {
      watch.abort();
      cancelHold();
      cancelAnimationFrame(frame);
      setCarried(null);
      cancel.current = () => {};
      // The click event of this gesture comes right after it.
      after(50, () => {
        lifted.current = false;
      });
    };
    cancel.current = end;

    held.addEventListener('contextmenu', (menu) => menu.preventDefault(), { signal });
    if (source.from) held.setPointerCapture(event.pointerId);
    window.addEventListener(
      'pointermove',
      ({ pointerId, clientX, clientY }) => {
        if (pointerId !== event.pointerId) return;
        last = { x: clientX, y: clientY };
        if (!moved && Math.hypot(last.x - start.x, last.y - start.y) < SLACK) return;
        if (!ready) end();
        else if (moved) point();
        else lift();
      },
      { signal },
    );
    window.addEventListener(
      'pointerup',
      (up) => {
        if (up.pointerId !== event.pointerId) return;
        end();
        if (needsHold && isTap(event, up, HOLD)) lifted.current = false;
        else if (moved && gap) onDrop(source, gap);
      },
      { signal },
    );
    window.addEventListener('pointercancel', ({ pointerId }) => pointerId === event.pointerId && end(), { signal });
    onEscape(end, signal);
  }

  return { carried, take, cancel };
}

/** @returns insert position of a drop; null outside of the lanes */
function gapAt(lanes: Element, x: number, y: number): Place | null {
  const inside = (element: Element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    return x >= left && x <= right && y >= top && y <= bottom;
  };
  if (!inside(lanes)) return null;
  const lane = [...lanes.querySelectorAll('.lane')].find(inside) as HTMLElement | undefined;
  if (!lane) return null;
  const cards = [...lane.querySelectorAll('.card')];
  const before = cards.findIndex((card) => {
    const { top, height } = card.getBoundingClientRect();
    return y < top + height / 2;
  });
  return { layer: lane.dataset.layer as Layer, at: before < 0 ? cards.length : before };
}
