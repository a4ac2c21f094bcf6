/**
 * Mouse, touch and keyboard handling of a text item and its tail. A drag, or a key that is held down, is one undo step.
 */

import { useRef } from 'preact/hooks';
import type { Bounds } from '../engine/types.ts';
import { WAYS } from '../page/panels/panel-shape.ts';
import { useApp } from '../ui/context.ts';
import { knobOf } from './word-places.ts';

/** Step of an arrow key in page widths, and with Shift. */
const STEP = 0.005;
const LARGE_STEP = 0.03;
/** Pixels before a press counts as a drag. */
const SLACK = 4;

/** Rotations nearer than this to a right angle snap to it, in degrees. */
const CLOSE = 4;
const RIGHT = 90;

/** in page widths */
type Place = [number, number];
type Grip = { id: number; x: number; y: number; at: Place; gesture: string; moved: boolean };
/** The last press: whether the text item was already selected by a tap, and whether it was dragged. */
type Press = { chosen: boolean; moved: boolean; tapped: boolean };

/** @param event on the page or something on it */
export function pointOn({ clientX, clientY, currentTarget }: MouseEvent): Place {
  const { left, top, width } = pageOf(currentTarget);
  return [(clientX - left) / width, (clientY - top) / width];
}

function pageOf(element: EventTarget | null) {
  return ((element as Element).closest('.page') as Element).getBoundingClientRect();
}

export function useWordHands(index: number) {
  const { lettering } = useApp();
  /** The gesture of the key that turns. */
  const held = useRef('');
  const last = useRef({ chosen: false, moved: false, tapped: false } as Press);
  const middle = () => lettering.pageAt(index);
  const tip = () => lettering.boxes.peek()[index]?.tip ?? middle();
  const body = useHand(middle, (to, gesture) => lettering.move(index, to, gesture));
  const tail = useHand(tip, (to, gesture) => lettering.point(index, to, gesture));
  const size = useHand(corner, (to, gesture) => {
    const [x] = middle();
    if (lettering.words.peek()[index]?.kind !== 'effect') lettering.resize(index, 2 * Math.abs(to[0] - x), gesture);
    else {
      // The size of rotated and bent text follows the distance of the pointer.
      const box = lettering.boxes.peek()[index];
      const now = distance(corner(), middle());
      if (box && now > 0) lettering.resize(index, (widthOf() * distance(to, middle())) / now, gesture);
    }
  });
  const turned = useHand(knob, ([x, y], gesture) => {
    const [mx, my] = middle();
    const angle = (Math.atan2(y - my, x - mx) * 180) / Math.PI + 90;
    // Upright is found again without looking at numbers.
    const straight = Math.round(angle / RIGHT) * RIGHT;
    lettering.turn(index, Math.round(Math.abs(angle - straight) < CLOSE ? straight : angle), gesture);
  });

  /** The lower right corner of its box. */
  function corner(): Place {
    const box = lettering.boxes.peek()[index];
    return box ? [box.x + box.width, box.y + box.height] : middle();
  }

  function widthOf(): number {
    return lettering.words.peek()[index]?.width ?? lettering.boxes.peek()[index]?.width ?? 0;
  }

  function knob(): Place {
    return knobOf(middle(), lettering.boxes.peek()[index], lettering.words.peek()[index]?.angle);
  }

  function press(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Enter') lettering.editing.value = index;
    else if (event.key === 'Delete' || event.key === 'Backspace') {
      lettering.remove(index);
      // Moves the focus to another text item, so that it does not go to the top of the window.
      requestAnimationFrame(() => focusOn('[data-word]', '.panels > [tabindex="0"]'));
    } else if (event.key === 'Escape' && lettering.mode.peek()) lettering.mode.value = null;
    else if (event.key === 'Escape' && lettering.chosen.peek() === index) lettering.choose(-1);
    else {
      body.onKeyDown(event);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  return {
    body: {
      ...body,
      onKeyDown: press,
      onPointerDown: (event: PointerEvent) => {
        const { tapped } = last.current;
        last.current = { chosen: tapped && lettering.chosen.peek() === index, moved: false, tapped };
        body.onPointerDown(event);
      },
      onPointerUp: () => {
        last.current.moved = body.onPointerUp();
      },
      onClick: (event: MouseEvent) => {
        event.stopPropagation();
        const { chosen, moved } = last.current;
        last.current.tapped = true;
        // On touch screens, a second tap starts editing, because users rarely try a double tap.
        if (chosen && !moved && (event as PointerEvent).pointerType === 'touch') lettering.editing.value = index;
        else lettering.choose(index);
      },
      onDblClick: () => {
        lettering.editing.value = index;
      },
    },
    tail: {
      ...tail,
      onPointerUp: () => void tail.onPointerUp(),
      onClick: (event: MouseEvent) => event.stopPropagation(),
    },
    size: {
      ...size,
      onPointerUp: () => void size.onPointerUp(),
      onClick: (event: MouseEvent) => event.stopPropagation(),
    },
    knob: {
      ...turned,
      onPointerUp: () => void turned.onPointerUp(),
      onClick: (event: MouseEvent) => event.stopPropagation(),
      onKeyDown: turnByKey,
      onKeyUp: () => {
        held.current = '';
      },
    },
    /** Positions of the handles, in page widths. */
    corner,
    knobAt: knob,
  };

  function turnByKey(event: KeyboardEvent) {
    const way = WAYS[event.key];
    if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const by = (way[0] || way[1]) * (event.shiftKey ? 15 : 1);
    if (held.current === '') held.current = lettering.step();
    lettering.turn(index, (lettering.words.peek()[index]?.angle ?? 0) + by, held.current);
  }

  function useHand(where: () => Place, put: (to: Place, gesture: string) => void) {
    const grip = useRef(null as Grip | null);
    const keys = useRef('');
    return {
      onPointerDown: (event: PointerEvent) => {
        // The page below must neither be panned nor turned.
        event.stopPropagation();
        if (event.button !== 0) return;
        const { pointerId: id, clientX: x, clientY: y } = event;
        grip.current = { id, x, y, at: where(), gesture: lettering.step(), moved: false };
        (event.currentTarget as Element).setPointerCapture(id);
      },
      onPointerMove: (event: PointerEvent) => {
        const held = grip.current;
        if (held?.id !== event.pointerId) return;
        event.stopPropagation();
        const [x, y] = [event.clientX - held.x, event.clientY - held.y];
        if (!held.moved && Math.hypot(x, y) < SLACK) return;
        if (!held.moved) lettering.choose(index);
        held.moved = true;
        const { width } = pageOf(event.currentTarget);
        put([held.at[0] + x / width, held.at[1] + y / width], held.gesture);
      },
      /** @returns whether it was moved */
      onPointerUp: (): boolean => {
        const moved = grip.current?.moved ?? false;
        grip.current = null;
        return moved;
      },
      onPointerCancel: () => {
        grip.current = null;
      },
      onKeyDown: (event: KeyboardEvent) => {
        const way = WAYS[event.key];
        if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        event.stopPropagation();
        lettering.choose(index);
        const step = event.shiftKey ? LARGE_STEP : STEP;
        if (keys.current === '') keys.current = lettering.step();
        const [x, y] = where();
        put([x + way[0] * step, y + way[1] * step], keys.current);
      },
      onKeyUp: () => {
        keys.current = '';
      },
    };
  }
}

function distance([ax, ay]: Place, [bx, by]: Place): number {
  return Math.hypot(ax - bx, ay - by);
}

/** @param selectors the first one that matches an element sets the focus */
export function focusOn(...selectors: string[]) {
  const found = selectors.map((selector) => document.querySelector(selector)).find((element) => element !== null);
  (found as HTMLElement | undefined)?.focus();
}

/**
 * Around the middle of a box, for an element that may be larger than it.
 * @param box in page widths
 * @param height of the page, in its widths
 */
export function placed({ x, y, width, height: tall }: Bounds, height: number) {
  const percent = (part: number) => `${(part * 100).toFixed(3)}%`;
  return {
    left: percent(x + width / 2),
    top: percent((y + tall / 2) / height),
    width: percent(width),
    height: percent(tall / height),
  };
}
