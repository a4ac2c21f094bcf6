// @ts-check
/**
 * What a person does to the page: shuffle, choose, lock, set, walk through what was shown.
 */

import { freshPageId, position } from './history.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./project.js').Part} Part */
/** @typedef {import('./project.js').PageSettings} PageSettings */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').PlanRequest} PlanRequest */
/** @typedef {import('../engine/documents.js').Keep} Keep */

/** A page of more panels than this is a page of stamps, unless a person asks for it. */
const MOST_PANELS = 9;

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

/** @returns {number} a seed that was likely never used */
export function freshSeed() {
  return crypto.getRandomValues(new Uint32Array(1))[0];
}

/**
 * @param {Store} store
 * @param {() => number} [seed]
 */
export function createPages(store, seed = freshSeed) {
  return {
    plan, show, amend, refine, reorder, refit, shuffle, chooseLayout, chooseStyle, lock, wantPanels, changeSettings, previous, next, undo, redo,
  };

  /**
   * A new page from the photos in use; null while there are none.
   * @param {Partial<PlanRequest> & { keep: Keep }} wish
   * @returns {PageDocument | null}
   */
  function plan(wish) {
    const planner = store.planner.peek();
    const { settings, page } = store.project.peek();
    const photos = store.photos.peek();
    if (!planner || photos.length === 0) return null;
    const free = !wish.keep.layout && wish.layout === undefined;
    return planner.plan({ seed: seed(), photos, page: settings, current: page, ...(free ? shape() : {}), ...wish });
  }

  /**
   * What a free layout must have: the number of panels that a person wants, or else a place for each locked photo.
   * @returns {Partial<PlanRequest>}
   */
  function shape() {
    const { page, panels, locks } = store.project.peek();
    const places = locks.photos && page ? { panels: placesOf(page) } : {};
    return panels === null ? places : { ...places, panels };
  }

  /**
   * Makes a page the page.
   * @param {PageDocument | null} page
   * @param {{ silent?: boolean, gesture?: string }} [how]
   */
  function show(page, how) {
    if (page) store.change({ type: 'show-page', page, pageId: freshPageId(store.history.peek()), ...how });
  }

  /**
   * The page after a change by hand; what it does not touch stays.
   * @param {PageDocument} changed
   * @param {{ gesture?: string }} [how]
   */
  function amend(changed, how) {
    const page = plan({ keep: KEEP_ALL, current: changed, seed: changed.seed });
    if (page) store.change({ type: 'change-page', page, ...how });
  }

  /** Fits the crops of the page to what is known of its photos by now. */
  function refine() {
    const { page } = store.project.peek();
    const better = page && plan({ keep: KEEP_ALL, seed: page.seed });
    if (better && JSON.stringify(better) !== JSON.stringify(page)) {
      store.change({ type: 'change-page', page: better, silent: true });
    }
  }

  /** Puts the photos of the first page in their right order, some of them set aside, in the same layout if they still fill it. */
  function reorder() {
    const { page } = store.project.peek();
    if (!page) return;
    const { length } = store.photos.peek();
    const layout = length >= page.panels.length;
    const better = plan({ keep: { layout, style: true, photos: false }, seed: page.seed, ...(layout ? {} : { panels: length }) });
    if (better) store.change({ type: 'change-page', page: better, silent: true });
  }

  /**
   * A page after the photos in use changed: as it was where it can be.
   * @param {{ grow: boolean }} how whether there are more photos than before
   * @returns {PageDocument | null}
   */
  function refit({ grow }) {
    const { page, locks, panels } = store.project.peek();
    const enough = page !== null && store.photos.peek().length >= page.panels.length;
    const layout = locks.layout || (panels !== null && page?.panels.length === panels) || (enough && !grow);
    // A photo that was just added is looked for on the page, so each gets a panel.
    const all = grow && !layout && panels === null ? { panels: Math.min(store.photos.peek().length, MOST_PANELS) } : {};
    return plan({ keep: { layout, style: true, photos: locks.photos || !grow }, ...all });
  }

  /** @param {Part | 'all'} part */
  function shuffle(part) {
    const { locks, page } = store.project.peek();
    if (!page || (part !== 'all' && locks[part])) return;
    // A locked panel stays where it is.
    if (part === 'all') show(plan({ keep: { ...locks, layout: locks.layout || page.panels.some((panel) => panel.locked) }, mode: 'shuffle' }));
    else if (part === 'photos') show(plan({ keep: { ...KEEP_ALL, photos: false }, mode: 'photos' }));
    else show(plan({ keep: { ...KEEP_ALL, [part]: false } }));
  }

  /** @param {string | object} layout */
  function chooseLayout(layout) {
    show(plan({ keep: { ...KEEP_ALL }, layout }));
  }

  /** @param {string | object} style */
  function chooseStyle(style) {
    show(plan({ keep: { ...KEEP_ALL }, style }));
  }

  /** @param {Part} part @param {boolean} on */
  function lock(part, on) {
    store.change({ type: 'lock', part, on });
  }

  /** @param {number | null} count */
  function wantPanels(count) {
    const gesture = `panels-${count}`;
    store.change({ type: 'want-panels', count, gesture });
    const { page } = store.project.peek();
    if (count === null || !page || page.panels.length === count) return;
    show(plan({ keep: { ...KEEP_ALL, layout: false } }), { gesture });
  }

  /**
   * @param {Partial<PageSettings>} wish
   * @param {string} [gesture] names one drag of a control, which is one step of the undo
   */
  function changeSettings(wish, gesture) {
    const { settings, page } = store.project.peek();
    const changed = { ...settings, ...wish };
    const resized = changed.width * settings.height !== changed.height * settings.width;
    // Another aspect may not suit the layout; the planner then takes one that does, unless it is locked.
    const keep = { ...KEEP_ALL, layout: !resized || store.project.peek().locks.layout || suits(page, changed) };
    const next = page && plan({ keep, page: changed, seed: page.seed });
    store.change({ type: 'change-settings', settings: changed, page: next, gesture });
  }

  /**
   * Whether the layout of the page is as good on another page as it is on its own.
   * @param {PageDocument | null} page
   * @param {PageSettings} changed
   */
  function suits(page, changed) {
    const planner = store.planner.peek();
    if (!page || !planner) return true;
    return planner.layoutFacts(page.layout, changed).good || !store.layoutFacts.peek()?.good;
  }

  /** @param {number} step */
  function walk(step) {
    const history = store.history.peek();
    const target = history.shown[position(history) + step];
    if (target) store.change({ type: 'show-page', page: target.page, pageId: target.id });
  }

  function previous() { walk(-1); }

  function next() { walk(1); }

  function undo() {
    store.change({ type: 'undo' });
  }

  function redo() {
    store.change({ type: 'redo' });
  }
}

/**
 * @param {PageDocument} page
 * @returns {number} the images on it: merged panels share one
 */
function placesOf({ panels, merges }) {
  return merges.reduce((places, group) => places - group.length + 1, panels.length);
}

/** @typedef {ReturnType<typeof createPages>} Pages */
