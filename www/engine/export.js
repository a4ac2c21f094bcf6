// @ts-check
/**
 * Pages at print size. The photos are decoded again from their files, each once a page, by as many workers as there
 * are; one worker puts the panels together and encodes. Many pages are made one after the other: one of A4 takes 35 MB.
 */

import { Priority } from './queue.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {PixelPatch & { index: number }} PanelPatch */
/** @typedef {{ signal?: AbortSignal, onProgress?: (done: number, total: number) => void }} Call */
/**
 * @typedef {{
 *   run: (job: import('./pool.js').Job) => Promise<any>, photos: ReturnType<typeof import('./photos.js').createPhotos>,
 *   words: Pick<ReturnType<typeof import('./words.js').createWords>, 'patches'>, files: ReturnType<typeof import('./files.js').createFiles>,
 * }} Parts
 */

/** What stands on the page of a single panel; its patch brings the rest. */
const ALONE = { layout: 'grid-2', panels: [{ photo: null, crop: null }, { photo: null, crop: null }], merges: [], words: [] };

/** @param {Parts} parts */
export function createExports({ run, photos, words, files }) {
  return { exportPng, exportJpeg, exportWebp, exportPdf, exportPanel };

  /**
   * @param {PageDocument} document
   * @param {Call} [call]
   * @returns {Promise<Blob>}
   */
  async function exportPng(document, call) {
    return whole(document, call, (patches, signal) => encode(document, patches, signal));
  }

  /** @param {PageDocument} document @param {PixelPatch[]} patches are handed over @param {AbortSignal} signal */
  async function encode(document, patches, signal) {
    const numbered = patches.map((patch, index) => ({ ...patch, index }));
    const args = { document: JSON.stringify(document), width: document.page.width, patches: numbered };
    const transfer = patches.map((patch) => patch.data.buffer);
    return run({ op: 'encode', args, transfer, priority: Priority.PAGE, signal });
  }

  /**
   * @param {PageDocument} document
   * @param {Call & { quality: number }} call `quality` from 1 to 100
   * @returns {Promise<Blob>}
   */
  async function exportJpeg(document, { quality, ...call }) {
    return whole(document, call, (patches, signal) => files.jpeg(document, document.page, patches, quality, { signal }));
  }

  /**
   * @param {PageDocument} document
   * @param {Call & { quality: number }} call
   * @returns {Promise<Blob>} rejects with `no-webp` where the browser makes none
   */
  async function exportWebp(document, { quality, ...call }) {
    const png = await exportPng(document, call);
    return files.webp(png, { quality, dpi: document.page.dpi }, call);
  }

  /**
   * @param {readonly PageDocument[]} documents
   * @param {Call & { quality: number, title: string }} call
   * @returns {Promise<Blob>} one file of all pages
   */
  async function exportPdf(documents, { quality, title, ...call }) {
    const step = steps(documents.reduce((sum, document) => sum + shown(document), 1), call.onProgress);
    return stoppable(call.signal, async (signal) => {
      const pages = [];
      for (const document of documents) {
        // Borders are lines of the file, so the panels are drawn without.
        const bare = { ...document, page: { ...document.page, border: 0 } };
        const pictures = await byPhoto(bare, undefined, signal, async (patches) => {
          const made = await files.pictures(document, patches, quality, { signal });
          step(patches.length);
          return made;
        });
        pages.push({ document, pictures });
      }
      const pdf = await files.pdf(pages, title, { signal });
      step(1);
      return pdf;
    });
  }

  /**
   * One panel with the words that stand on it, as large as it is on the page, and on its paper where it is no rectangle.
   * @param {PageDocument} document
   * @param {number} index
   * @param {Call} [call]
   * @returns {Promise<Blob>} a PNG
   */
  async function exportPanel(document, index, call = {}) {
    const step = steps(2, call.onProgress);
    return stoppable(call.signal, async (signal) => {
      const [panel] = await byPhoto(document, [index], signal, async (patches) => patches);
      step(1);
      const own = { ...document, words: document.words?.filter((word) => word.panel === index) };
      const written = await words.patches(own, document.page.width, { signal });
      const { x, y, width, height } = panel;
      // The panel's rectangle is a page of its own, on which all lies that much further left and up.
      const page = { ...document.page, width, height };
      const moved = [panel, ...written].map((patch) => ({ ...patch, x: patch.x - x, y: patch.y - y }));
      const png = await encode({ ...document, ...ALONE, page }, moved, signal);
      step(1);
      return png;
    });
  }

  /**
   * @param {PageDocument} document
   * @param {Call | undefined} call
   * @param {(patches: PixelPatch[], signal: AbortSignal) => Promise<Blob>} encode of the panels and the words, in their order
   */
  async function whole(document, { signal: stop, onProgress } = {}, encode) {
    // Encoding counts as one step.
    const step = steps(shown(document) + 1, onProgress);
    return stoppable(stop, async (signal) => {
      const panels = await byPhoto(document, undefined, signal, async (patches) => {
        step(patches.length);
        return patches;
      });
      const written = await words.patches(document, document.page.width, { signal });
      const file = await encode([...panels, ...written], signal);
      step(1);
      return file;
    });
  }

  /**
   * Draws the panels, those of one photo together.
   * @template {{ index: number }} T
   * @param {PageDocument} document
   * @param {readonly number[] | undefined} wanted all unless told
   * @param {AbortSignal} signal
   * @param {(patches: PanelPatch[]) => Promise<T[]>} use what becomes of those of one photo
   * @returns {Promise<T[]>} in the order of the panels
   */
  async function byPhoto(document, wanted, signal, use) {
    const json = JSON.stringify(document);
    const { width } = document.page;
    const parts = await Promise.all([...panelsByPhoto(document, wanted)].map(async ([id, indexes]) => {
      const { file, name } = photos.get(id);
      const args = { id, file, document: json, indexes, width };
      return use(await run({ op: 'fullPanels', args, photo: name, priority: Priority.PAGE, signal }));
    }));
    return parts.flat().sort((a, b) => a.index - b.index);
  }
}

/**
 * @template T
 * @param {AbortSignal | undefined} signal
 * @param {(signal: AbortSignal) => Promise<T>} work whose first failure stops the rest
 */
async function stoppable(signal, work) {
  const stop = new AbortController();
  try {
    return await work(signal ? AbortSignal.any([signal, stop.signal]) : stop.signal);
  } finally {
    stop.abort();
  }
}

/** @param {number} total @param {Call['onProgress']} [onProgress] */
function steps(total, onProgress = () => {}) {
  let done = 0;
  onProgress(done, total);
  return (/** @type {number} */ count) => onProgress(done += count, total);
}

/** @param {PageDocument} document */
function shown(document) {
  return document.panels.filter((panel) => panel.photo !== null).length;
}

/**
 * @param {PageDocument} document
 * @param {readonly number[]} [wanted]
 * @returns {Map<string, number[]>} the panels that show a photo, by its id
 */
function panelsByPhoto(document, wanted) {
  /** @type {Map<string, number[]>} */
  const groups = new Map();
  document.panels.forEach(({ photo }, index) => {
    if (photo !== null && (!wanted || wanted.includes(index))) groups.set(photo, [...(groups.get(photo) ?? []), index]);
  });
  return groups;
}
