/**
 * Photos moved in their panels by mouse and touch: a drag pans, beyond the panel it carries the photo to another one;
 * wheel and pinch zoom; a double click fits the subject. By touch a panel is chosen first, as a swipe turns the page.
 */

import { signal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { PHOTO } from '../../photos/photo-drag.ts';
import { useApp } from '../../ui/context.ts';
import type { Bounds } from '../../engine/types.ts';
import type { Signal } from '@preact/signals';

type Point = { x: number; y: number };
type Grip = { panel: number; crop: Bounds; from: Point; span: number; gesture: string; moved: boolean };

/** Pixels before a press counts as a drag. */
const SLACK = 4;
/** Turns of the wheel closer together than this, in ms, are one step of the undo. */
const TURN = 500;

/** The panel that a photo is held over. */
export const target: Signal<number | null> = signal(null);

/** The photo that the pointer carries to another panel, and the pointer's position in the window. */
export const carried: Signal<(Point & { photo: string }) | null> = signal(null);

export function usePanelGestures() {
  const { framing, selection } = useApp();
  const hands = useRef(new Map() as Map<number, Point>);
  const grip = useRef(null as Grip | null);
  const dragged = useRef(false);
  const wheel = useRef({ at: 0, panel: -1, gesture: '' });

  function hold(panel: number, gesture: string) {
    const crop = framing.cropOf(panel);
    const [from, span] = middle([...hands.current.values()]);
    grip.current = crop && !framing.isLocked(panel) ? { panel, crop, from, span, gesture, moved: false } : null;
  }

  function down(event: PointerEvent, panel: number) {
    if (event.button !== 0) return;
    dragged.current = false;
    const touch = event.pointerType === 'touch';
    if (!touch || hands.current.size === 0) hands.current.clear();
    hands.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const pinch = hands.current.size > 1;
    if (touch && !pinch && !selection.panels.peek().includes(panel)) {
      grip.current = null;
      return;
    }
    // The second finger is let through: it ends the swipe that the first began.
    if (!pinch) event.stopPropagation();
    hold(pinch ? (grip.current?.panel ?? panel) : panel, framing.step());
  }

  function move(event: PointerEvent) {
    const held = grip.current;
    if (!hands.current.has(event.pointerId)) return;
    hands.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const bounds = held && framing.boundsOf(held.panel);
    if (!held || !bounds) return;
    const element = event.currentTarget as HTMLElement;
    const [now, span] = middle([...hands.current.values()]);
    const [x, y] = [now.x - held.from.x, now.y - held.from.y];
    const pinch = hands.current.size > 1;
    if (!held.moved && Math.hypot(x, y) < SLACK && Math.abs(span - held.span) < SLACK) return;
    event.stopPropagation();
    if (!held.moved) element.setPointerCapture(event.pointerId);
    held.moved = true;
    dragged.current = true;
    const page = (element.parentElement as HTMLElement).getBoundingClientRect();
    const parts = [x / page.width / bounds.width, y / page.width / bounds.height] as [number, number];
    const over = pinch ? null : panelAt(event, element);
    target.value = over === held.panel || over === null || framing.isLocked(over) ? null : over;
    const photo = target.value === null ? null : framing.photoOf(held.panel);
    carried.value = photo === null ? null : { photo, x: event.clientX, y: event.clientY };
    framing.held.value = photo === null ? held.panel : null;
    if (target.value !== null) framing.pan(held.panel, held.crop, [0, 0], held.gesture);
    else if (pinch)
      framing.zoom(held.panel, held.crop, span / held.span, within(held.from, page, bounds), held.gesture);
    else framing.pan(held.panel, held.crop, parts, held.gesture);
  }

  function up(event: PointerEvent) {
    const held = grip.current;
    hands.current.delete(event.pointerId);
    grip.current = null;
    if (held?.moved) event.stopPropagation();
    if (held && target.peek() !== null && event.type === 'pointerup') {
      framing.swap(held.panel, target.peek() as number, held.gesture);
    }
    target.value = null;
    carried.value = null;
    framing.held.value = null;
  }

  function turn(event: WheelEvent, panel: number) {
    const crop = framing.cropOf(panel);
    const bounds = framing.boundsOf(panel);
    if (!crop || !bounds || event.deltaY === 0) return;
    event.preventDefault();
    const last = wheel.current;
    const joins = event.timeStamp - last.at < TURN && last.panel === panel;
    wheel.current = { at: event.timeStamp, panel, gesture: joins ? last.gesture : framing.step() };
    const page = ((event.currentTarget as HTMLElement).parentElement as HTMLElement).getBoundingClientRect();
    const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * 30;
    const factor = Math.exp(-Math.max(-240, Math.min(240, pixels)) * (event.ctrlKey ? 0.01 : 0.002));
    framing.zoom(
      panel,
      crop,
      factor,
      within({ x: event.clientX, y: event.clientY }, page, bounds),
      wheel.current.gesture,
    );
  }

  return {
    /** @returns whether the click that follows is the end of a drag */
    wasDrag: (): boolean => dragged.current,
    on: (panel: number) => ({
      onPointerDown: (event: PointerEvent) => down(event, panel),
      onPointerMove: move,
      onPointerUp: up,
      onPointerCancel: up,
      onWheel: (event: WheelEvent) => turn(event, panel),
      onDblClick: () => framing.fit(panel),
      onDragOver: (event: DragEvent) => {
        if (!event.dataTransfer?.types.includes(PHOTO) || framing.isLocked(panel)) return;
        event.preventDefault();
        target.value = panel;
      },
      onDragLeave: () => {
        target.value = null;
      },
      onDrop: (event: DragEvent) => {
        target.value = null;
        const photo = event.dataTransfer?.getData(PHOTO);
        if (!photo) return;
        event.preventDefault();
        framing.replace(panel, photo);
      },
    }),
  };
}

/**
 * @param point on the screen
 * @param bounds in page widths
 * @returns parts of the bounds
 */
export function within({ x, y }: Point, page: DOMRect, bounds: Bounds): [number, number] {
  return [
    ((x - page.left) / page.width - bounds.x) / bounds.width,
    ((y - page.top) / page.width - bounds.y) / bounds.height,
  ];
}

/** @returns the centre and the distance of the points */
function middle(points: Point[]): [Point, number] {
  const [a, b = a] = points;
  return [{ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, Math.max(1, Math.hypot(a.x - b.x, a.y - b.y))];
}

/**
 * @param element a panel
 * @returns the panel under the pointer
 */
function panelAt({ clientX, clientY }: PointerEvent, element: HTMLElement): number | null {
  const under = document.elementFromPoint(clientX, clientY);
  const at = [...(element.parentElement as HTMLElement).children].indexOf(under as Element);
  return at < 0 ? null : at;
}
