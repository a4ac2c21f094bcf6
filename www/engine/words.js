// @ts-check
/**
 * Words on pages: a wasm module of its own with the fonts, loaded when a page first has words. One worker draws them; on
 * the main thread the same module says where they are, while a page is planned.
 */

import { createPool } from './pool.js';
import { failure } from './protocol.js';
import { Priority } from './queue.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./documents.js').Word} Word */
/** @typedef {import('./documents.js').WordBox} WordBox */
/** @typedef {import('./protocol.js').BitmapPatch} BitmapPatch */
/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {import('./engine.js').Call} Call */
/** @typedef {Awaited<ReturnType<ReturnType<typeof createWords>['lettering']>>} Lettering */

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);
export function createWords() {
  /** @type {ReturnType<typeof createPool> | undefined} */
  let pool;
  /** @type {ReturnType<typeof open> | null} */
  let opened = null;

  return { lettering, draw, patches, over, lay, dispose: () => pool?.dispose() };

  /** What plans with words: pure functions of a millisecond. The next call tries again where it failed. */
  function lettering() {
    opened ??= open().catch((error) => {
      opened = null;
      throw error;
    });
    return opened;
  }

  /**
   * @param {string} op
   * @param {PageDocument} document
   * @param {object} args
   * @param {Call & { transfer?: Transferable[] }} [call]
   */
  function run(op, document, args, call) {
    pool ??= createPool({ size: 1, spawn });
    return pool.run({ op, args: { document: JSON.stringify(document), ...args }, priority: Priority.PANEL, ...call });
  }

  /**
   * One word of a page.
   * @param {PageDocument} document
   * @param {number} index
   * @param {number} width of the page, in pixels
   * @param {Call} [call]
   * @returns {Promise<BitmapPatch>}
   */
  async function draw(document, index, width, call) {
    return run('word', document, { index, width }, call);
  }

  /**
   * All words of a page, as pixels.
   * @param {PageDocument} document
   * @param {number} width
   * @param {Call} [call]
   * @returns {Promise<PixelPatch[]>}
   */
  async function patches(document, width, call) {
    return document.words?.length ? run('words', document, { width }, call) : [];
  }

  /**
   * The picture of a page with its words over it.
   * @param {PageDocument} document
   * @param {number} width
   * @param {BitmapPatch} page
   * @param {Call} [call]
   * @returns {Promise<BitmapPatch>}
   */
  async function over(document, width, page, call) {
    if (!document.words?.length) return page;
    const { bitmap } = page;
    return { ...page, bitmap: await run('over', document, { width, bitmap }, { ...call, transfer: [bitmap] }) };
  }

  /**
   * The same for pixels: the words are laid on those of an opaque page.
   * @param {PageDocument} document
   * @param {number} width
   * @param {PixelPatch} page
   * @param {Call} [call]
   */
  async function lay(document, width, page, call) {
    for (const patch of await patches(document, width, call)) layPixels(page, patch);
    return page;
  }
}

/**
 * @param {PixelPatch} page
 * @param {PixelPatch} patch straight alpha; what is beyond the page is left out
 */
export function layPixels(page, patch) {
  for (let y = Math.max(0, -patch.y); y < patch.height && patch.y + y < page.height; y += 1) {
    for (let x = Math.max(0, -patch.x); x < patch.width && patch.x + x < page.width; x += 1) {
      const from = (y * patch.width + x) * 4;
      const to = ((patch.y + y) * page.width + patch.x + x) * 4;
      const alpha = patch.data[from + 3];
      for (let i = 0; i < 3; i += 1) {
        // As the core rounds it.
        page.data[to + i] = Math.floor((patch.data[from + i] * alpha + page.data[to + i] * (255 - alpha) + 127) / 255);
      }
    }
  }
}

async function open() {
  const [{ default: init, Lettering }, bytes] = await Promise.all([import('../pkg-words/inkpanel.js'), loadWords()]);
  await init({ module_or_path: bytes });
  const letters = new Lettering();
  return {
    /**
     * @param {PageDocument} document
     * @param {Record<string, object[]>} subjects what is in the photos, by their ids
     * @returns {Word[]} the words of the document, those placed by themselves where they hide no face
     */
    settle: (document, subjects) => JSON.parse(letters.settle(JSON.stringify(document), JSON.stringify(subjects))),
    /**
     * @param {PageDocument} document
     * @returns {WordBox[]}
     */
    measure: (document) => JSON.parse(letters.measure(JSON.stringify(document))),
  };
}

/** @returns {Promise<ArrayBuffer>} rejects with `words-missing` */
export async function loadWords() {
  const response = await fetch(MODULE).catch(() => null);
  // A host may answer with a page of its own where a file is missing.
  const text = response?.headers.get('content-type')?.startsWith('text/html');
  if (!response?.ok || text) throw failure('words-missing', 'The letters could not be loaded.');
  return response.arrayBuffer();
}

function spawn() {
  return new Worker(new URL('./word-worker.js', import.meta.url), { type: 'module', name: 'inkpanel-words' });
}
