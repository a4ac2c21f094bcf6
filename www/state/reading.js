// @ts-check
/**
 * Photos in: the page is laid out for all of them at once and its panels fill as they are read, so that nothing
 * jumps. A file that cannot be read is named, and the rest go on.
 */

import { failure } from '../engine/protocol.js';
import { Priority } from '../engine/queue.js';
import { strings } from '../strings.js';
import { byName } from './album.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('./messages.js').Messages} Messages */
/** @typedef {import('./album.js').Fact} Fact */
/** @typedef {{ file: string, title: string, author: string, licence: string }} Sample */
/** @typedef {Pick<import('../engine/engine.js').Engine, 'importPhoto' | 'forgetPhoto' | 'ready'>} Engine */
/** @typedef {ReturnType<typeof createReading>} Reading */

/** The first page shows this many photos at most: large enough to be looked at. */
const FIRST_PANELS = 6;

/**
 * @param {{ store: Store, pages: Pages, engine: Engine, messages: Messages }} app
 */
export function createReading({ store, pages, engine, messages }) {
  let lastId = 0;
  let clicks = 0;
  /** The photos of the last plan, to see whether another is due. */
  let planned = '';
  /** The step of the undo that the photos being read belong to; none for the first, which cannot be undone. */
  let gesture = /** @type {string | null} */ (null);

  return { addFiles, addSamples, use, remove };

  /**
   * @param {readonly File[]} given
   * @param {ReadonlyMap<string, string>} [credits] the authors to name, by file name
   */
  async function addFiles(given, credits) {
    if (given.length === 0) return;
    try {
      // Nothing can be laid out before the planner is there.
      await engine.ready;
    } catch {
      return;
    }
    const first = store.tray.peek().length === 0;
    const fresh = byName(given).map((file) => ({ id: `p${(lastId += 1)}`, file }));
    for (const { id, file } of fresh) {
      store.know({ id, name: file.name, credit: credits?.get(file.name), meta: null, measures: null });
    }
    count(0, fresh.length);
    const ids = fresh.map(({ id }) => id);
    if (first) {
      gesture = null;
      store.change({ type: 'add-photos', ids, silent: true });
      planned = inUse();
      const panels = Math.min(ids.length, FIRST_PANELS);
      pages.show(pages.plan({ keep: { layout: false, style: false, photos: false }, panels }), { silent: true });
    } else {
      // A page that is there stays as it is until the new photos are known to be any good.
      gesture ??= `add-${lastId}`;
      store.change({ type: 'add-photos', ids, gesture });
    }
    await Promise.all(fresh.map((entry) => read(entry)));
    if (!store.reading.peek()) settle();
  }

  /** @param {{ id: string, file: File }} entry */
  async function read({ id, file }) {
    try {
      if (file.type.startsWith('video/')) throw failure('video', strings.noVideo);
      const visible = store.page.peek()?.panels.some((panel) => panel.photo === id);
      const meta = await engine.importPhoto(id, file, { priority: visible ? Priority.PAGE : Priority.REST });
      store.know({ .../** @type {Fact} */ (store.album.peek().get(id)), meta, measures: meta.measures });
      if (store.page.peek()?.panels.some((panel) => panel.photo === id)) pages.refine();
    } catch (error) {
      const { code, message } = /** @type {{ code: string, message: string }} */ (error);
      messages.alert(strings.fileFailed(file.name, strings.reasons[code] ?? message));
      store.change({ type: 'forget-photos', ids: [id] });
    } finally {
      count(1, 0);
    }
  }

  /**
   * @param {number} done
   * @param {number} more
   */
  function count(done, more) {
    const { done: before, total } = store.reading.peek() ?? { done: 0, total: 0 };
    const progress = { done: before + done, total: total + more };
    store.reading.value = progress.done < progress.total ? progress : null;
  }

  /** All are read: duplicates are set aside and the order of time is known, which may ask for another page. */
  function settle() {
    const step = gesture;
    gesture = null;
    if (store.photos.peek().length === 0) {
      store.change({ type: 'no-page', silent: true });
      messages.alert(strings.noUsablePhoto);
    } else if (planned === inUse()) {
      pages.refine();
    } else {
      planned = inUse();
      if (step !== null) pages.show(pages.refit({ grow: true }), { gesture: step });
      else pages.reorder();
    }
  }

  function inUse() {
    return store.photos.peek().map(({ id }) => id).join();
  }

  /** The album that ships with the program. */
  async function addSamples() {
    if (store.fetching.peek()) return;
    store.fetching.value = true;
    try {
      const base = new URL('./samples/', document.baseURI);
      /** @type {Sample[]} */
      const index = await (await fetchOk(new URL('index.json', base))).json();
      const files = index.map(async ({ file }) => new File([await (await fetchOk(new URL(file, base))).blob()], file));
      const credits = index.map((sample) => /** @type {[string, string]} */ ([sample.file, strings.credit(sample)]));
      const album = await Promise.all(files);
      store.fetching.value = false;
      await addFiles(album, new Map(credits));
    } catch {
      store.fetching.value = false;
      messages.alert(strings.noSamples);
    }
  }

  /**
   * @param {string} id
   * @param {boolean} on
   */
  function use(id, on) {
    edit({ type: 'use-photo', id, use: on }, on);
  }

  /** @param {string} id */
  function remove(id) {
    edit({ type: 'remove-photo', id }, false);
  }

  /**
   * A change of the tray and the page that follows from it, as one step.
   * @param {import('./project.js').Action} action
   * @param {boolean} grow
   */
  function edit(action, grow) {
    clicks += 1;
    const step = { gesture: `tray-${clicks}` };
    store.change({ ...action, ...step });
    planned = inUse();
    const page = pages.refit({ grow });
    if (page) pages.show(page, step);
    else store.change({ type: 'no-page', ...step });
  }
}

/** @param {URL} address */
async function fetchOk(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname}: ${response.status}`);
  return response;
}
