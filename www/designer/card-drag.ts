/**
 * Cards of the designer that are carried to another place, also in the other layer: by their heads with a mouse, by
 * their handles with a finger or a pen, which scroll elsewhere. Near an edge the lanes scroll by themselves.
 */

import { useRef, useState } from 'preact/hooks';
import { onEscape } from '../ui/on-escape.ts';
import type { Layer, Place } from '../engine/types.ts';

/** a card, and before which one it would land */
type Carried = { from: Place; gap: Place | null };
export type CardDrag = ReturnType<typeof useCardDrag>;

/** What a shaking hand moves, in CSS pixels. */
const SLACK = 5;
/** How near to an edge the lanes scroll, and how fast at most, in CSS pixels a frame. */
const EDGE = 56;
const SPEED = 12;

export function useCardDrag(onDrop: (from: Place, to: Place) => void) {
  const [carried, setCarried] = useState(null as Carried | null);
  /** Ends what is under way, without dropping. */
  const cancel = useRef(() => {});

  /** @param event on a card's head */
  function take(event: PointerEvent, from: Place) {
    const target = event.target as Element;
    if (!event.isPrimary || event.button !== 0 || (event.pointerType !== 'mouse' && !target.closest('.card-handle')))
      return;
    const head = event.currentTarget as HTMLElement;
    const lanes = head.closest('.lanes') as HTMLElement;
    const start = { x: event.clientX, y: event.clientY };
    let last = start;
    let gap: Place | null = null;
    let moved = false;
    let frame = 0;
    cancel.current();
    const watch = new AbortController();
    const { signal } = watch;

    const point = () => {
      gap = gapAt(lanes, last.x, last.y);
      setCarried({ from, gap });
    };
    const scroll = () => {
      const { top, bottom } = lanes.getBoundingClientRect();
      const into = Math.max(0, last.y - (bottom - EDGE)) - Math.max(0, top + EDGE - last.y);
      if (into !== 0) {
        lanes.scrollTop += Math.max(-1, Math.min(1, into / EDGE)) * SPEED;
        point();
      }
      frame = requestAnimationFrame(scroll);
    };
    const end = () => {
      watch.abort();
      cancelAnimationFrame(frame);
      setCarried(null);
      cancel.current = () => {};
    };
    cancel.current = end;

    head.setPointerCapture(event.pointerId);
    head.addEventListener(
      'pointermove',
      ({ clientX, clientY }) => {
        last = { x: clientX, y: clientY };
        if (!moved && Math.hypot(last.x - start.x, last.y - start.y) < SLACK) return;
        if (!moved) frame = requestAnimationFrame(scroll);
        moved = true;
        point();
      },
      { signal },
    );
    head.addEventListener(
      'pointerup',
      () => {
        end();
        if (!moved || !gap) return;
        // Taking the card out moves those behind it up by one.
        const to = gap.layer === from.layer && from.at < gap.at ? gap.at - 1 : gap.at;
        if (gap.layer !== from.layer || to !== from.at) onDrop(from, { layer: gap.layer, at: to });
      },
      { signal },
    );
    head.addEventListener('pointercancel', end, { signal });
    head.addEventListener('lostpointercapture', end, { signal });
    onEscape(end, signal);
  }

  return { carried, take, cancel };
}

/** @returns where a card that is let go there belongs; nowhere outside of the lanes */
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
