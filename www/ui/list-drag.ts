/**
 * Drag and drop in lists, such as the page strip and the shot table. A mouse drags immediately. A finger or pen drags
 * after a long press, because a moving touch scrolls the list. Near an end the list scrolls automatically.
 */

import { useRef, useState } from 'preact/hooks';
import { onEscape } from './on-escape.ts';
import { after } from '../engine/scheduler.ts';
import { isTap } from './pointing.ts';

/** The index of the dragged item, and the gap where it would land. */
type Carried = { from: number; gap: number | null };
/** Selectors of the scrolling list, and of its items. */
type Where = { list: string; item: string };
export type ListDrag = ReturnType<typeof useListDrag>;

/** Tolerance for unsteady hands, in CSS pixels. */
const SLACK = 5;
/** Duration of a long press in ms. */
const PRESS = 350;
/** Distance from an end at which the list scrolls, and maximum speed in CSS pixels per frame. */
const EDGE = 40;
const SPEED = 10;
/** Maximum distance from the list for a drop, in CSS pixels. */
const BESIDE = 60;

/** @param onDrop `to`: its index after removal */
export function useListDrag({ list: listOf, item: itemOf }: Where, onDrop: (from: number, to: number) => void) {
  const [carried, setCarried] = useState(null as Carried | null);
  /** Whether the click that follows belongs to a drag. */
  const dragged = useRef(false);

  /** @param event on an item, or a handle in it */
  function take(event: PointerEvent, from: number) {
    if (!event.isPrimary || event.button !== 0) return;
    const held = event.currentTarget as HTMLElement;
    const list = held.closest(listOf) as HTMLElement;
    const start = { x: event.clientX, y: event.clientY };
    const mouse = event.pointerType === 'mouse';
    let last = start;
    let gap: number | null = null;
    let holds = false;
    let frame = 0;
    const watch = new AbortController();
    const { signal } = watch;
    dragged.current = false;

    const point = () => {
      gap = gapAt(list, itemOf, last.x, last.y);
      setCarried({ from, gap });
    };
    const scroll = () => {
      if (scrollNear(list, last.x, last.y)) point();
      frame = requestAnimationFrame(scroll);
    };
    const begin = () => {
      holds = true;
      dragged.current = true;
      held.setPointerCapture(event.pointerId);
      frame = requestAnimationFrame(scroll);
      point();
    };
    if (mouse) held.setPointerCapture(event.pointerId);
    const cancel = mouse ? () => {} : after(PRESS, begin);
    const end = () => {
      watch.abort();
      cancel();
      cancelAnimationFrame(frame);
      setCarried(null);
    };

    held.addEventListener(
      'pointermove',
      ({ clientX, clientY }) => {
        last = { x: clientX, y: clientY };
        const far = Math.hypot(last.x - start.x, last.y - start.y) > SLACK;
        if (holds) point();
        else if (far && mouse) begin();
        else if (far) end();
      },
      { signal },
    );
    held.addEventListener(
      'pointerup',
      (up) => {
        end();
        if (!mouse && isTap(event, up, PRESS)) dragged.current = false;
        if (!dragged.current || gap === null) return;
        // Removing it moves later ones up by one.
        const to = from < gap ? gap - 1 : gap;
        if (to !== from) onDrop(from, to);
      },
      { signal },
    );
    for (const type of ['pointercancel', 'lostpointercapture']) held.addEventListener(type, end, { signal });
    // A drag neither scrolls the list nor opens a menu.
    for (const type of ['touchmove', 'contextmenu'])
      list.addEventListener(type, (other) => holds && other.preventDefault(), { signal, passive: false });
    onEscape(end, signal);
  }

  return { carried, take, dragged };
}

/** Returns whether its items are in a column. */
function isColumn(list: Element) {
  const { display, flexDirection } = getComputedStyle(list);
  return !display.includes('flex') || flexDirection === 'column';
}

/** @returns insert position of a drop; null far from the list */
function gapAt(list: HTMLElement, itemOf: string, x: number, y: number): number | null {
  const box = list.getBoundingClientRect();
  const column = isColumn(list);
  const beside = column ? Math.max(box.left - x, x - box.right) : Math.max(box.top - y, y - box.bottom);
  if (beside > BESIDE) return null;
  const items = [...list.querySelectorAll(itemOf)];
  const before = items.findIndex((item) => {
    const { left, top, width, height } = item.getBoundingClientRect();
    return column ? y < top + height / 2 : x < left + width / 2;
  });
  return before < 0 ? items.length : before;
}

/** @returns whether it was scrolled */
function scrollNear(list: HTMLElement, x: number, y: number): boolean {
  const { left, right, top, bottom } = list.getBoundingClientRect();
  const [at, from, to] = isColumn(list) ? [y, top, bottom] : [x, left, right];
  const into = Math.max(0, at - (to - EDGE)) - Math.max(0, from + EDGE - at);
  if (into === 0) return false;
  const by = Math.max(-1, Math.min(1, into / EDGE)) * SPEED;
  list.scrollBy(isColumn(list) ? { top: by } : { left: by });
  return true;
}
