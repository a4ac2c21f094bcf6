/**
 * Manual editing of photos in panels: move, zoom, fit, swap, replace, lock. An edit of a panel affects all panels that
 * share its image.
 */

import { computed, effect, signal } from '@preact/signals';
import { grown } from './merging.ts';
import type { Pages } from '../../document/pages.ts';
import type { Store } from '../../document/store.ts';
import type { Bounds, CropChange, PageDocument } from '../../engine/types.ts';
import type { Signal } from '@preact/signals';

export type Framing = ReturnType<typeof createFraming>;

/**
 * The purpose of the next key or click on the page. `at` is the position of the focus point, as fractions of the image.
 */
export type Mode = { kind: 'frame' | 'swap' | 'focus' | 'replace'; panel: number; at?: [number, number] };

export function createFraming({ store, pages }: { store: Store; pages: Pages }) {
  let steps = 0;
  const mode: Signal<Mode | null> = signal(null);
  /** The photo that the next clicked panel will show. */
  const placing: Signal<string | null> = signal(null);
  /** The panel whose photo is being cropped. */
  const cropping: Signal<number | null> = signal(null);
  /** The panel whose photo is being dragged or zoomed. */
  const held: Signal<number | null> = signal(null);
  /** The panel whose whole photo is shown, as its crop changes. */
  const framed = computed(
    () => held.value ?? cropping.value ?? (mode.value?.kind === 'frame' ? mode.value.panel : null),
  );
  // Any other edit, undo or redo cancels the placing of a photo.
  let last = store.step.peek();
  effect(() => {
    if (store.step.value === last) return;
    last = store.step.value;
    placing.value = null;
  });

  return {
    mode,
    placing,
    cropping,
    held,
    framed,
    groupAt: groupOf,
    place,
    placeIn,
    step,
    toggle,
    cropOf,
    photoOf,
    boundsOf,
    isLocked,
    pan,
    zoom,
    closer,
    fit,
    reset,
    swap,
    swapWith,
    replace,
    lock,
    focus,
    breakFrame,
  };

  /** @returns the name of a new gesture: all that bears it is one step of the undo */
  function step(): string {
    steps += 1;
    return `frame-${steps}`;
  }

  function toggle(kind: Mode['kind'], panel: number) {
    mode.value = mode.peek()?.kind === kind ? null : { kind, panel };
  }

  /** @returns the crop of its photo, or `null` for an empty panel */
  function cropOf(panel: number): Bounds | null {
    const page = store.page.peek();
    const use = page?.panels[groupOf(page, panel)[0]];
    return use?.photo ? use.crop : null;
  }

  /** @returns of its image on the page, in page widths */
  function boundsOf(panel: number): Bounds | null {
    const page = store.page.peek();
    const panels = store.geometry.peek()?.panels;
    if (!page || !panels?.[panel]) return null;
    return groupOf(page, panel)
      .map((i) => panels[i].bounds)
      .reduce(union);
  }

  function isLocked(panel: number) {
    return store.page.value?.panels[panel]?.locked ?? false;
  }

  /**
   * @param from the crop at the start of the drag
   * @param by parts of the image
   */
  function pan(panel: number, from: Bounds, [x, y]: [number, number], gesture: string) {
    crop(panel, { type: 'pan', from, x, y }, gesture);
  }

  function zoom(panel: number, from: Bounds, factor: number, at: [number, number] | undefined, gesture: string) {
    crop(panel, { type: 'zoom', from, factor, at }, gesture);
  }

  function closer(panel: number, factor: number, gesture: string = step()) {
    crop(panel, { type: 'zoom', factor }, gesture);
  }

  /** Shows the subject large; without one, what the page would choose. */
  function fit(panel: number) {
    crop(panel, { type: 'fit' }, step());
  }

  /** The crop that the page would choose. */
  function reset(panel: number) {
    crop(panel, { type: 'reset' }, step());
  }

  /** Text does not move while a photo is cropped. */
  function crop(panel: number, change: CropChange, gesture: string) {
    store.change({ type: 'crop-panel', panel, crop: change, gesture });
  }

  function swap(one: number, other: number, gesture?: string) {
    pages.edit({ type: 'swap-panels', panel: one, with: other, gesture });
  }

  /** Ends the mode for it. */
  function swapWith(panel: number) {
    const from = mode.peek();
    mode.value = null;
    if (from?.kind === 'swap') swap(from.panel, panel);
  }

  /** Takes a photo up, for the panel that is pressed next; null lays it down again. */
  function place(photo: string | null) {
    mode.value = null;
    placing.value = photo;
  }

  /** @returns whether a photo was placed */
  function placeIn(panel: number): boolean {
    const photo = placing.peek();
    if (photo === null) return false;
    placing.value = null;
    replace(panel, photo);
    return true;
  }

  function replace(panel: number, photo: string) {
    if (mode.peek()?.kind === 'replace') mode.value = null;
    if (isLocked(panel) || photoOf(panel) === photo) return;
    const gesture = step();
    // A photo that was set aside is in use from now on.
    if (!store.photos.peek().some(({ id }) => id === photo))
      store.change({ type: 'use-photos', uses: { [photo]: true }, gesture });
    pages.edit({ type: 'place-photo', panel, photo, gesture });
  }

  function lock(panel: number, on: boolean) {
    pages.edit({ type: 'lock-panel', panel, on });
  }

  /**
   * Sets the focus point of the photo in a panel. Every crop contains it, and the crops of the page are computed again.
   * @param at fractions of the image; `null` removes the point
   */
  function focus(panel: number, at: [number, number] | null) {
    const id = photoOf(panel);
    const crop = cropOf(panel);
    if (!id || !crop) return;
    const gesture = step();
    const point = at && { x: crop.x + at[0] * crop.width, y: crop.y + at[1] * crop.height };
    store.change({ type: 'focus-photo', id, focus: point, gesture });
    pages.edit({ type: 'recrop-photo', photo: id, everywhere: false, gesture });
  }

  /**
   * Lets the subject of a panel's photo step out of it, for which the crop may change, or no longer.
   * @returns whether it could be done
   */
  function breakFrame(panel: number, on: boolean): boolean {
    const before = store.page.peek();
    const mask = store.masks.peek().get(before?.panels[panel]?.photo ?? '') ?? null;
    if (on && mask === null) return false;
    store.change({ type: 'break-frame', panel, mask: on ? mask : null, gesture: step() });
    return store.page.peek() !== before;
  }

  function photoOf(panel: number) {
    const page = store.page.peek();
    return page?.panels[groupOf(page, panel)[0]]?.photo ?? null;
  }
}

/** @returns the panels that share its image, starting with the first of the group */
function groupOf(page: PageDocument, panel: number): number[] {
  return grown([panel], page);
}

function union(a: Bounds, b: Bounds): Bounds {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)];
  return {
    x,
    y,
    width: Math.max(a.x + a.width, b.x + b.width) - x,
    height: Math.max(a.y + a.height, b.y + b.height) - y,
  };
}
