// @ts-check
/**
 * Photos in panels, by hand: moved, enlarged, fitted, exchanged, replaced, locked. What is done to a panel is done to
 * all that share its image.
 */

import { signal } from '@preact/signals';
import { fitted, panned, zoomed } from './crop.js';
import { grown } from './merging.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('./crop.js').Crop} Crop */
/** @typedef {import('../engine/documents.js').Bounds} Bounds */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').PanelUse} PanelUse */
/** @typedef {ReturnType<typeof createFraming>} Framing */

/**
 * What the next key or click on the page is for; `at` is where the focus point would be, in parts of the image.
 * @typedef {{ kind: 'frame' | 'swap' | 'focus', panel: number, at?: [number, number] }} Mode
 */

/** @param {{ store: Store, pages: Pages }} app */
export function createFraming({ store, pages }) {
  let steps = 0;
  /** @type {import('@preact/signals').Signal<Mode | null>} */
  const mode = signal(null);

  return { mode, step, toggle, cropOf, boundsOf, isLocked, pan, zoom, closer, fit, reset, swap, swapWith, replace, lock, focus };

  /** @returns {string} the name of a new gesture: all that bears it is one step of the undo */
  function step() {
    steps += 1;
    return `frame-${steps}`;
  }

  /** @param {Mode['kind']} kind @param {number} panel */
  function toggle(kind, panel) {
    mode.value = mode.peek()?.kind === kind ? null : { kind, panel };
  }

  /** @param {number} panel @returns {Crop | null} what it shows; nothing for an empty panel */
  function cropOf(panel) {
    const page = store.page.peek();
    const use = page?.panels[groupOf(page, panel)[0]];
    return use?.photo ? use.crop : null;
  }

  /** @param {number} panel @returns {Bounds | null} of its image on the page, in page widths */
  function boundsOf(panel) {
    const page = store.page.peek();
    const panels = store.geometry.peek()?.panels;
    if (!page || !panels?.[panel]) return null;
    return groupOf(page, panel).map((i) => panels[i].bounds).reduce(union);
  }

  /** @param {number} panel */
  function isLocked(panel) {
    return store.page.value?.panels[panel]?.locked ?? false;
  }

  /**
   * @param {number} panel
   * @param {Crop} from the crop when it was taken hold of
   * @param {[number, number]} by parts of the image
   * @param {string} gesture
   */
  function pan(panel, from, [x, y], gesture) {
    setCrop(panel, panned(from, x, y), gesture);
  }

  /**
   * @param {number} panel
   * @param {Crop} from
   * @param {number} factor
   * @param {[number, number] | undefined} at
   * @param {string} gesture
   */
  function zoom(panel, from, factor, at, gesture) {
    setCrop(panel, zoomed(from, factor, at), gesture);
  }

  /** @param {number} panel @param {number} factor @param {string} [gesture] */
  function closer(panel, factor, gesture = step()) {
    const crop = cropOf(panel);
    if (crop) zoom(panel, crop, factor, undefined, gesture);
  }

  /** Shows the subject large; without one, what the page would choose. @param {number} panel */
  function fit(panel) {
    const bounds = boundsOf(panel);
    const meta = store.photos.peek().find(({ id }) => id === photoOf(panel));
    const crop = meta && bounds && fitted(/** @type {any} */ (meta.subjects), meta, bounds.width / bounds.height);
    if (crop) setCrop(panel, crop, step());
    else reset(panel);
  }

  /** The crop that the page would choose. @param {number} panel */
  function reset(panel) {
    change(panel, { crop: null, edited: false }, step());
  }

  /** @param {number} one @param {number} other @param {string} [gesture] */
  function swap(one, other, gesture) {
    const page = store.page.peek();
    if (!page || isLocked(one) || isLocked(other)) return;
    const [a, b] = [groupOf(page, one), groupOf(page, other)];
    if (a[0] === b[0]) return;
    const fresh = (/** @type {number} */ from) => ({ photo: page.panels[from].photo, crop: null, edited: false });
    const panels = page.panels.map((panel, i) => (
      a.includes(i) ? { ...panel, ...fresh(b[0]) } : b.includes(i) ? { ...panel, ...fresh(a[0]) } : panel
    ));
    pages.amend({ ...page, panels }, { gesture });
  }

  /** Ends the mode for it. @param {number} panel */
  function swapWith(panel) {
    const from = mode.peek();
    mode.value = null;
    if (from?.kind === 'swap') swap(from.panel, panel);
  }

  /** @param {number} panel @param {string} photo */
  function replace(panel, photo) {
    if (isLocked(panel) || photoOf(panel) === photo) return;
    const gesture = step();
    // A photo that was set aside is in use from now on.
    if (!store.photos.peek().some(({ id }) => id === photo)) store.change({ type: 'use-photo', id: photo, use: true, gesture });
    change(panel, { photo, crop: null, edited: false }, gesture);
  }

  /** @param {number} panel @param {boolean} on */
  function lock(panel, on) {
    change(panel, { locked: on });
  }

  /**
   * Marks the point that matters in the photo of a panel; every crop keeps it, and those of the page are made anew.
   * @param {number} panel
   * @param {[number, number] | null} at parts of the image; none forgets the point
   */
  function focus(panel, at) {
    const page = store.page.peek();
    const id = photoOf(panel);
    const crop = cropOf(panel);
    if (!page || !id || !crop) return;
    const gesture = step();
    const point = at && { x: crop.x + at[0] * crop.width, y: crop.y + at[1] * crop.height };
    store.change({ type: 'focus-photo', id, focus: point, gesture });
    const panels = page.panels.map((use) => (use.photo === id && !use.locked ? { ...use, crop: null, edited: false } : use));
    pages.amend({ ...page, panels }, { gesture });
  }

  /** @param {number} panel @param {Crop} crop @param {string} gesture */
  function setCrop(panel, crop, gesture) {
    const page = store.page.peek();
    if (!page || isLocked(panel)) return;
    const group = groupOf(page, panel);
    const panels = page.panels.map((use, i) => (group.includes(i) ? { ...use, crop, edited: true } : use));
    store.change({ type: 'change-page', page: { ...page, panels }, gesture });
  }

  /** @param {number} panel @param {Partial<PanelUse>} news @param {string} [gesture] */
  function change(panel, news, gesture) {
    const page = store.page.peek();
    if (!page || (isLocked(panel) && news.locked === undefined)) return;
    const group = groupOf(page, panel);
    pages.amend({ ...page, panels: page.panels.map((use, i) => (group.includes(i) ? { ...use, ...news } : use)) }, { gesture });
  }

  /** @param {number} panel */
  function photoOf(panel) {
    const page = store.page.peek();
    return page?.panels[groupOf(page, panel)[0]]?.photo ?? null;
  }
}

/** @param {PageDocument} page @param {number} panel @returns {number[]} the panels that share its image, the first of them first */
function groupOf(page, panel) {
  return grown([panel], page);
}

/** @param {Bounds} a @param {Bounds} b @returns {Bounds} */
function union(a, b) {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)];
  return { x, y, width: Math.max(a.x + a.width, b.x + b.width) - x, height: Math.max(a.y + a.height, b.y + b.height) - y };
}
