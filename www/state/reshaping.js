// @ts-check
/**
 * Layouts that a person makes: a surprise, a cut that is moved, a panel that is split or taken away. The layout then
 * stands in the page in full, like any other.
 */

import { signal } from '@preact/signals';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').PanelUse} PanelUse */
/** @typedef {import('../engine/documents.js').LayoutChange} LayoutChange */
/** @typedef {ReturnType<typeof createReshaping>} Reshaping */

/** Panels of a surprise where no number is wanted. */
const USUAL = { least: 3, most: 8 };

/** @type {PanelUse} */
const EMPTY = { photo: null, crop: null, locked: false, edited: false };

/**
 * @param {{ store: Store, pages: Pages, seed: () => number }} app
 */
export function createReshaping({ store, pages, seed }) {
  return {
    /** Whether the cuts show their handles. */
    editing: signal(false),
    /** The cut that was chosen last, by its place in the facts of the layout. @type {import('@preact/signals').Signal<number | null>} */
    cut: signal(null),
    surprise,
    moveCut,
    splitPanel,
    removePanel,
  };

  /** A layout that nobody has seen, with the wanted number of panels. */
  function surprise() {
    const planner = store.planner.peek();
    const { panels, settings, page } = store.project.peek();
    if (!planner || !page) return;
    const most = Math.max(USUAL.least, Math.min(USUAL.most, store.photos.peek().length));
    const count = panels === null ? { least: USUAL.least, most } : { least: panels, most: panels };
    pages.chooseLayout(planner.generateLayout({ seed: seed(), page: settings, ...count }));
  }

  /**
   * @param {number} cut its place in the facts of the layout
   * @param {{ fraction: number, slant: number }} to
   * @param {string} gesture names the drag, which is one step of the undo
   */
  function moveCut(cut, to, gesture) {
    change({ type: 'move-cut', cut, ...to }, (page) => page, gesture);
  }

  /**
   * @param {number} panel
   * @param {'rows' | 'columns'} axis
   */
  function splitPanel(panel, axis) {
    change({ type: 'split', panel, axis }, (page) => spliced(page, panel, 1));
  }

  /** @param {number} panel */
  function removePanel(panel) {
    change({ type: 'remove', panel }, (page) => spliced(page, panel, -1));
  }

  /**
   * @param {LayoutChange} wish
   * @param {(page: PageDocument) => PageDocument} follow what becomes of the panels
   * @param {string} [gesture]
   */
  function change(wish, follow, gesture) {
    const planner = store.planner.peek();
    const page = store.page.peek();
    if (!planner || !page) return;
    const layout = planner.changeLayout(page.layout, wish);
    pages.amend({ ...follow(page), layout }, { gesture });
  }
}

/**
 * The page with an open panel after that one, or without that one; merges that lose their sense are parted.
 * @param {PageDocument} page
 * @param {number} panel
 * @param {1 | -1} by
 * @returns {PageDocument}
 */
export function spliced(page, panel, by) {
  const panels = [...page.panels];
  if (by > 0) panels.splice(panel + 1, 0, EMPTY);
  else panels.splice(panel, 1);
  const moved = (/** @type {number} */ other) => (other > panel ? other + by : other);
  // The half of a merged panel, or what is left of a group, need not hang together any more.
  const merges = page.merges.filter((group) => !group.includes(panel)).map((group) => group.map(moved));
  return { ...page, panels, merges };
}
