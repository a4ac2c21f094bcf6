// @ts-check
/**
 * The page as a file: rendered at print size in the background, with progress, one at a time.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings.js';
import { save } from './files.js';
import { sized } from './paper.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('./messages.js').Messages} Messages */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').PageSettings} PageSettings */
/** @typedef {ReturnType<typeof createDownload>} Download */

/**
 * @param {{ store: Store, pages: Pages, engine: Pick<import('../engine/engine.js').Engine, 'exportPng'>, messages: Messages,
 *   pageFiles: Pick<import('./keeping/page-files.js').PageFiles, 'take' | 'carrying'> }} app
 */
export function createDownload({ store, pages, engine, messages, pageFiles }) {
  /** @type {import('@preact/signals').Signal<import('./store.js').Progress | null>} */
  const progress = signal(null);
  /** @type {AbortController | null} */
  let running = null;

  return { progress, start, cancel, preview };

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
    if (!page || running) return;
    running = new AbortController();
    // At once: what the person chose is for this file.
    const cargo = pageFiles.take();
    try {
      const { signal: stop } = running;
      const onProgress = (/** @type {number} */ done, /** @type {number} */ total) => {
        progress.value = { done, total };
      };
      const { png, unclean } = await pageFiles.carrying(await engine.exportPng(page, { signal: stop, onProgress }), page, cargo);
      if (stop.aborted) return;
      save(png, fileName(page));
      messages.note(unclean > 0 ? `${strings.saved} ${strings.photosUnclean(unclean)}` : strings.saved);
    } catch (error) {
      const { code, message, photo } = /** @type {{ code?: string, message: string, photo?: string }} */ (error);
      // The loss of a worker says itself what it was busy with.
      const why = photo && code !== 'worker-lost' ? strings.fileFailed(photo, strings.reasons[code ?? ''] ?? message) : message;
      if (code !== 'cancelled') messages.alert(strings.exportFailed(why));
    } finally {
      running = null;
      progress.value = null;
    }
  }

  function cancel() {
    running?.abort();
  }
}

/** @param {PageDocument} page */
function fileName({ layout, style, seed }) {
  const name = (/** @type {string | { id?: string }} */ part) => (typeof part === 'string' ? part : part.id ?? 'own');
  return `inkpanel-${name(layout)}-${name(style)}-${seed}.png`;
}
