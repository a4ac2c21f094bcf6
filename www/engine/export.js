// @ts-check
/**
 * A page at print size. The photos are decoded again from their files, each once, by as many workers as there
 * are; one worker puts the panels together and encodes.
 */

import { Priority } from './queue.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */

/** Decoding a very large photo and styling it at print size may take its time on a phone. */
const TIMEOUT = 180_000;

/**
 * @param {{ run: (job: import('./pool.js').Job) => Promise<any>, photos: ReturnType<typeof import('./photos.js').createPhotos>, words: Pick<ReturnType<typeof import('./words.js').createWords>, 'patches'> }} engine
 * @param {PageDocument} document
 * @param {{ signal?: AbortSignal, onProgress?: (done: number, total: number) => void }} [call]
 * @returns {Promise<Blob>}
 */
export async function exportPng({ run, photos, words }, document, { signal, onProgress = () => {} } = {}) {
  const { width } = document.page;
  const json = JSON.stringify(document);
  const groups = panelsByPhoto(document);
  // Encoding counts as one step.
  const total = document.panels.filter((panel) => panel.photo !== null).length + 1;
  // The first failure stops the rest.
  const stop = new AbortController();
  const either = signal ? AbortSignal.any([signal, stop.signal]) : stop.signal;
  let done = 0;
  onProgress(done, total);
  try {
    /** @type {(PixelPatch & { index: number })[][]} */
    const parts = await Promise.all([...groups].map(async ([id, indexes]) => {
      const { file, name } = photos.get(id);
      const args = { id, file, document: json, indexes, width };
      const part = await run({ op: 'fullPanels', args, photo: name, priority: Priority.PAGE, timeout: TIMEOUT, signal: either });
      done += indexes.length;
      onProgress(done, total);
      return part;
    }));
    const written = await words.patches(document, width, { signal: either });
    const above = written.map((patch, i) => ({ ...patch, index: document.panels.length + i }));
    const patches = [...parts.flat().sort((a, b) => a.index - b.index), ...above];
    const transfer = patches.map((patch) => patch.data.buffer);
    const args = { document: json, width, patches };
    const png = await run({ op: 'encode', args, transfer, priority: Priority.PAGE, timeout: TIMEOUT, signal: either });
    onProgress(total, total);
    return png;
  } finally {
    stop.abort();
  }
}

/**
 * @param {PageDocument} document
 * @returns {Map<string, number[]>} the panels that show a photo, by its id
 */
function panelsByPhoto(document) {
  /** @type {Map<string, number[]>} */
  const groups = new Map();
  document.panels.forEach(({ photo }, index) => {
    if (photo !== null) groups.set(photo, [...(groups.get(photo) ?? []), index]);
  });
  return groups;
}
