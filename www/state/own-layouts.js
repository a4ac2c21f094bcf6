// @ts-check
/**
 * `My layouts`: kept in this browser (`keeping/shelves.js`), saved as files, opened from files. They are a part of the
 * project, so a layout that was removed comes back by undo.
 */

import { strings } from '../strings.js';
import { save as saveFile } from './files.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('./messages.js').Messages} Messages */
/** @typedef {import('../engine/documents.js').Template} Template */
/** @typedef {ReturnType<typeof createOwnLayouts>} OwnLayouts */

/** More would make the list long and the storage full; the oldest go. */
const MOST = 200;
/** No layout file is longer, in bytes; the core says so too, but only after all of it was read. */
const LONGEST = 256 * 1024;

/**
 * @param {{ store: Store, pages: Pages, messages: Messages }} app
 */
export function createOwnLayouts({ store, pages, messages }) {
  return { save, open, remove, isOwn };

  /** The layout of the page as a file, and in the list. */
  function save() {
    const layout = full();
    if (!layout) return;
    keep(layout);
    saveFile(new Blob([`${JSON.stringify(layout, null, 2)}\n`], { type: 'application/json' }), `${layout.id}.json`);
    messages.note(strings.layoutSaved);
  }

  /**
   * Takes layouts from files; the last good one becomes the page's.
   * @param {readonly File[]} files
   */
  async function open(files) {
    const planner = store.planner.peek();
    if (!planner) return;
    let last = /** @type {Template | null} */ (null);
    for (const file of files) {
      try {
        if (file.size > LONGEST) throw new Error(strings.layoutTooLong(file.name));
        last = planner.checkLayout(await file.text(), file.name);
        keep(last);
      } catch (error) {
        const { message } = /** @type {Error} */ (error);
        messages.fileFailed(file.name, message, { text: message });
      }
    }
    if (!last) return;
    if (store.page.peek()) pages.chooseLayout(last);
    else messages.note(strings.layoutKept);
  }

  /** @param {string} id */
  function remove(id) {
    write(store.own.peek().filter((layout) => layout.id !== id));
  }

  /** @returns {Template | null} the layout of the page in full */
  function full() {
    const page = store.page.peek();
    return (page && store.planner.peek()?.layoutFile(page.layout)) ?? null;
  }

  /** @param {string} id */
  function isOwn(id) {
    return store.own.value.some((layout) => layout.id === id);
  }

  /** @param {Template} layout */
  function keep(layout) {
    // One of the catalogue is in the list already.
    if (store.layouts.peek().some(({ id, own }) => id === layout.id && own === null)) return;
    write([layout, ...store.own.peek().filter(({ id }) => id !== layout.id)].slice(0, MOST));
  }

  /** @param {readonly Template[]} ownLayouts */
  function write(ownLayouts) {
    store.change({ type: 'own-layouts', ownLayouts });
  }
}
