// @ts-check
/**
 * Cards of the designer that are carried to another place, also in the other layer: by their heads with a mouse, by
 * their handles with a finger or a pen, which scroll elsewhere. Near an edge the lanes scroll by themselves.
 */

import { useRef, useState } from 'preact/hooks';
import { onEscape } from '../on-escape.js';

/** @typedef {import('../../state/designer-draft.js').Layer} Layer */
/** @typedef {{ layer: Layer, at: number }} Place */
/** @typedef {{ from: Place, gap: Place | null }} Carried a card, and before which one it would land */
/** @typedef {ReturnType<typeof useCardDrag>} CardDrag */

/** What a shaking hand moves, in CSS pixels. */
const SLACK = 5;
/** How near to an edge the lanes scroll, and how fast at most, in CSS pixels a frame. */
const EDGE = 56;
const SPEED = 12;

/** @param {(from: Place, to: Place) => void} onDrop */
export function useCardDrag(onDrop) {
  const [carried, setCarried] = useState(/** @type {Carried | null} */ (null));
  /** Ends what is under way, without dropping. */
  const cancel = useRef(() => {});

  /** @param {PointerEvent} event on a card's head @param {Place} from */
  function take(event, from) {
    const target = /** @type {Element} */ (event.target);
    if (!event.isPrimary || event.button !== 0 || (event.pointerType !== 'mouse' && !target.closest('.card-handle'))) return;
    const head = /** @type {HTMLElement} */ (event.currentTarget);
    const lanes = /** @type {HTMLElement} */ (head.closest('.lanes'));
    const start = { x: event.clientX, y: event.clientY };
    let last = start;
    /** @type {Place | null} */
    let gap = null;
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
    head.addEventListener('pointermove', ({ clientX, clientY }) => {
      last = { x: clientX, y: clientY };
      if (!moved && Math.hypot(last.x - start.x, last.y - start.y) < SLACK) return;
      if (!moved) frame = requestAnimationFrame(scroll);
      moved = true;
      point();
    }, { signal });
    head.addEventListener('pointerup', () => {
      end();
      if (!moved || !gap) return;
      // Taking the card out moves those behind it up by one.
      const to = gap.layer === from.layer && from.at < gap.at ? gap.at - 1 : gap.at;
      if (gap.layer !== from.layer || to !== from.at) onDrop(from, { layer: gap.layer, at: to });
    }, { signal });
    head.addEventListener('pointercancel', end, { signal });
    head.addEventListener('lostpointercapture', end, { signal });
    onEscape(end, signal);
  }

  return { carried, take, cancel };
}

/**
 * @param {Element} lanes
 * @param {number} x
 * @param {number} y
 * @returns {Place | null} where a card that is let go there belongs; nowhere outside of the lanes
 */
function gapAt(lanes, x, y) {
  const inside = (/** @type {Element} */ element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    return x >= left && x <= right && y >= top && y <= bottom;
  };
  if (!inside(lanes)) return null;
  const lane = /** @type {HTMLElement | undefined} */ ([...lanes.querySelectorAll('.lane')].find(inside));
  if (!lane) return null;
  const cards = [...lane.querySelectorAll('.card')];
  const before = cards.findIndex((card) => {
    const { top, height } = card.getBoundingClientRect();
    return y < top + height / 2;
  });
  return { layer: /** @type {Layer} */ (lane.dataset.layer), at: before < 0 ? cards.length : before };
}
