// @ts-check
/** Size, gutter, paper and the like: of all pages of a storyboard alike. */

import { sheetsOf } from './sheets.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').PageSettings} PageSettings */

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

/**
 * @param {{ store: import('./store.js').Store, plan: import('./pages.js').Plan }} app
 */
export function createPageSettings({ store, plan }) {
  return { changeSettings, fitted };

  /**
   * @param {Partial<PageSettings>} wish
   * @param {string} [gesture] names one drag of a control, which is one step of the undo
   */
  function changeSettings(wish, gesture) {
    const project = store.project.peek();
    const { settings, page, at } = project;
    const changed = { ...settings, ...wish };
    const sheets = sheetsOf(project).map((sheet) => ({ ...sheet, page: onPaper(sheet.page, changed) }));
    store.change({ type: 'change-settings', settings: changed, page: page && sheets[at].page, gesture });
    if (sheets.length > 1) store.change({ type: 'set-sheets', sheets, at, silent: true });
  }

  /**
   * A page that was shown before, on the paper that the storyboard has now; one that is alone brings its own.
   * @param {PageDocument} page
   * @returns {PageDocument}
   */
  function fitted(page) {
    const { settings, others } = store.project.peek();
    const same = Object.entries(settings).every(([field, value]) => page.page[/** @type {keyof PageSettings} */ (field)] === value);
    return others.length === 0 || same ? page : onPaper(page, settings);
  }

  /**
   * @param {PageDocument} page
   * @param {PageSettings} changed
   * @returns {PageDocument}
   */
  function onPaper(page, changed) {
    const resized = changed.width * page.page.height !== changed.height * page.page.width;
    // Another aspect may not suit the layout; the planner then takes one that does, unless it is locked.
    const keep = { ...KEEP_ALL, layout: !resized || store.project.peek().locks.layout || suits(page, changed) };
    const own = store.photos.peek().filter(({ id }) => page.panels.some(({ photo }) => photo === id));
    const alone = store.sheets.peek().length <= 1;
    // The photos of a page among others stay on it, whatever layout it gets.
    const cast = alone || own.length === 0 ? {} : { photos: own, ...(keep.layout ? {} : { panels: own.length }) };
    return plan({ keep, current: page, page: changed, seed: page.seed, ...cast }) ?? { ...page, page: changed };
  }

  /**
   * Whether a layout is as good on another page as it is on its own.
   * @param {PageDocument} page
   * @param {PageSettings} changed
   */
  function suits(page, changed) {
    const planner = store.planner.peek();
    return !planner || planner.layoutFacts(page.layout, changed).good || !planner.layoutFacts(page.layout, page.page).good;
  }
}
