/**
 * Pages of the storyboard that are carried to another place: with a mouse at once, with a finger or a pen after a long
 * press, since a touch that moves scrolls the strip. Near an end the strip scrolls by itself.
 */

import { useRef, useState } from 'preact/hooks';
import { onEscape } from '../ui/on-escape.ts';

/** a page, and before which one it would land */
type Carried = { from: number; gap: number | null };
export type PageDrag = ReturnType<typeof usePageDrag>;

/** What a shaking hand moves, in CSS pixels. */
const SLACK = 5;
/** A touch that rests for so long takes the page, in ms. */
const PRESS = 350;
/** How near to an end the strip scrolls, and how fast at most, in CSS pixels a frame. */
const EDGE = 40;
const SPEED = 10;
/** How far beside the strip a page may be let go, in CSS pixels. */
const BESIDE = 60;

/** @param onDrop `to`: its place once it was taken out */
export function usePageDrag(onDrop: (from: number, to: number) => void) {
  const [carried, setCarried] = useState(null as Carried | null);
  /** Whether the click that follows belongs to a drag. */
  const dragged = useRef(false);

  /** @param event on a page */
  function take(event: PointerEvent, from: number) {
    if (!event.isPrimary || event.button !== 0) return;
    const page = event.currentTarget as HTMLElement;
    const list = page.closest('.book-pages') as HTMLElement;
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
      gap = gapAt(list, last.x, last.y);
      setCarried({ from, gap });
    };
    const scroll = () => {
      if (scrollNear(list, last.x, last.y)) point();
      frame = requestAnimationFrame(scroll);
    };
    const begin = () => {
      holds = true;
      dragged.current = true;
      page.setPointerCapture(event.pointerId);
      frame = requestAnimationFrame(scroll);
      point();
    };
    if (mouse) page.setPointerCapture(event.pointerId);
    const timer = mouse ? 0 : setTimeout(begin, PRESS);
    const end = () => {
      watch.abort();
      clearTimeout(timer);
      cancelAnimationFrame(frame);
      setCarried(null);
    };

    page.addEventListener(
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
    page.addEventListener(
      'pointerup',
      () => {
        end();
        if (!holds || gap === null) return;
        // Taking the page out moves those behind it up by one.
        const to = from < gap ? gap - 1 : gap;
        if (to !== from) onDrop(from, to);
      },
      { signal },
    );
    for (const type of ['pointercancel', 'lostpointercapture']) page.addEventListener(type, end, { signal });
    // A page in hand neither scrolls the strip nor opens a menu.
    for (const type of ['touchmove', 'contextmenu'])
      list.addEventListener(type, (other) => holds && other.preventDefault(), { signal, passive: false });
    onEscape(end, signal);
  }

  return { carried, take, dragged };
}

function isColumn(list: Element) {
  return getComputedStyle(list).flexDirection === 'column';
}

/** @returns before which page one that is let go there belongs; nowhere far from the strip */
function gapAt(list: HTMLElement, x: number, y: number): number | null {
  const box = list.getBoundingClientRect();
  const column = isColumn(list);
  const beside = column ? Math.max(box.left - x, x - box.right) : Math.max(box.top - y, y - box.bottom);
  if (beside > BESIDE) return null;
  const pages = [...list.querySelectorAll('.book-page')];
  const before = pages.findIndex((page) => {
    const { left, top, width, height } = page.getBoundingClientRect();
    return column ? y < top + height / 2 : x < left + width / 2;
  });
  return before < 0 ? pages.length : before;
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
