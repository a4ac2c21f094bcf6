// @ts-check
/**
 * The ways out: pages as files, on the clipboard or in the share sheet, and one panel. Rendered at print size in the
 * background, with progress, one at a time.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings.js';
import { save } from './files.js';
import { FORMATS, fileName, isArchive, panelName } from './formats.js';
import { createMaking } from './page-making.js';
import { sized } from './paper.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('./messages.js').Messages} Messages */
/** @typedef {import('./page-making.js').Wish} Wish */
/** @typedef {import('./page-making.js').Work} Work */
/** @typedef {import('./page-making.js').Carry} Carry */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').PageSettings} PageSettings */
/** @typedef {ReturnType<typeof createDownload>} Download */

/**
 * @param {{
 *   store: Store, pages: Pages, messages: Messages,
 *   engine: Pick<import('../engine/engine.js').Engine, 'exportPng' | 'exportJpeg' | 'exportWebp' | 'exportPdf' | 'exportPanel'>,
 *   pageFiles: Pick<import('./keeping/page-files.js').PageFiles, 'take' | 'carrying'>,
 * }} app
 */
export function createDownload({ store, pages, engine, messages, pageFiles }) {
  /** @type {import('@preact/signals').Signal<import('./store.js').Progress | null>} */
  const progress = signal(null);
  /** @type {AbortController | null} */
  let running = null;
  const make = createMaking({ store, engine });

  return { progress, start, saveAs, copy, share, savePanel, cancel, preview, sheets, scaledSheets };

  /** @returns {readonly PageDocument[]} the pages of the storyboard, in their order */
  function sheets() {
    return store.sheets.value;
  }

  /**
   * All pages with more or fewer pixels, else as they are.
   * @param {number} factor
   * @returns {PageDocument[]}
   */
  function scaledSheets(factor) {
    const by = (/** @type {number} */ length) => Math.round(length * factor);
    return sheets().map((document) => {
      const { width, height, dpi } = document.page;
      return { ...document, page: sized(document.page, { width: by(width), height: by(height), dpi: by(dpi) }) };
    });
  }

  /**
   * The page at another size: the same photos in the same layout, cropped anew.
   * @param {Partial<PageSettings>} size
   * @returns {PageDocument | null}
   */
  function preview(size) {
    const page = store.page.peek();
    const settings = page && sized(page.page, size);
    if (!page || !settings) return null;
    const same = settings.width === page.page.width && settings.height === page.page.height;
    return same ? page : pages.plan({ keep: { layout: true, style: true, photos: true }, page: settings, seed: page.seed });
  }

  /** @param {PageDocument | null} [page] the page as it is, unless told */
  async function start(page = store.page.peek()) {
    if (page) await saveAs({ pages: [page], format: 'png' });
  }

  /** @param {Wish} wish */
  async function saveAs(wish) {
    const cargo = loaded(wish);
    const file = await work((how) => make(wish, how, cargo.carry), strings.exportFailed);
    if (!file) return;
    save(file, fileName(wish.pages, wish.format));
    const saved = strings.pagesSaved(wish.pages.length);
    messages.note(cargo.unclean > 0 ? `${saved} ${strings.photosUnclean(cargo.unclean)}` : saved);
  }

  /**
   * What the PNG of a wish carries of its project; `unclean`: photos in it that keep what their files say.
   * @param {Wish} wish
   */
  function loaded({ format, inside = 'png' }) {
    // At once: what the person chose is for this file.
    const what = (isArchive(format) ? inside : format) === 'png' ? pageFiles.take() : 'none';
    const cargo = {
      unclean: 0,
      carry: /** @type {Carry} */ (async (png, page) => {
        const carrying = await pageFiles.carrying(png, page, what);
        cargo.unclean += carrying.unclean;
        return carrying.png;
      }),
    };
    return cargo;
  }

  /** @param {number} index of a panel of the page */
  async function savePanel(index) {
    const page = store.page.peek();
    const file = page && await work((how) => engine.exportPanel(page, index, how), strings.exportFailed);
    if (!file) return;
    save(file, panelName(page, index));
    messages.note(strings.panelSaved);
  }

  /**
   * The browser is handed the promise of a picture, as some allow the clipboard only in the moment of the click.
   * @param {PageDocument} page
   */
  async function copy(page) {
    const png = work((how) => engine.exportPng(page, how), strings.exportFailed);
    const promised = png.then((file) => file ?? Promise.reject(new DOMException('', 'AbortError')));
    try {
      await navigator.clipboard.write([new ClipboardItem({ 'image/png': promised })]);
      messages.note(strings.copied);
    } catch (error) {
      // What stopped the picture itself has been said.
      if (await png) messages.alert(strings.copyFailed(/** @type {Error} */ (error).message));
    }
  }

  /** @param {Wish} wish */
  async function share(wish) {
    const made = await work((how) => make(wish, how, loaded(wish).carry), strings.exportFailed);
    if (made) await hand(new File([made], fileName(wish.pages, wish.format), { type: FORMATS[wish.format].type }));
  }

  /** @param {File} file */
  async function hand(file) {
    try {
      await navigator.share({ files: [file] });
    } catch (error) {
      const { name, message } = /** @type {Error} */ (error);
      // Drawing took longer than a click counts, so the browser wants another.
      if (name === 'NotAllowedError') messages.note(strings.readyToShare, { label: strings.sharePart, run: () => void hand(file) });
      else if (name !== 'AbortError') messages.alert(strings.shareFailed(message));
    }
  }

  /**
   * Runs one piece of work at a time, with progress; what goes wrong is said.
   * @param {(how: Work) => Promise<Blob>} make
   * @param {(why: string) => string} failed
   * @returns {Promise<Blob | null>} null where it was cancelled or failed
   */
  async function work(make, failed) {
    if (running) return null;
    running = new AbortController();
    const { signal: stop } = running;
    try {
      const made = await make({ signal: stop, onProgress: (done, total) => { progress.value = { done, total }; } });
      return stop.aborted ? null : made;
    } catch (error) {
      const { code, message, photo } = /** @type {{ code?: string, message: string, photo?: string }} */ (error);
      // The loss of a worker says itself what it was busy with.
      const why = photo && code !== 'worker-lost' ? strings.fileFailed(photo, strings.reasons[code ?? ''] ?? message) : message;
      if (code !== 'cancelled') messages.alert(failed(why));
      return null;
    } finally {
      running = null;
      progress.value = null;
    }
  }

  function cancel() {
    running?.abort();
  }
}
