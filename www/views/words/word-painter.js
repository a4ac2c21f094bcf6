// @ts-check
/**
 * Keeps the canvas of the words true to the document: one picture a word, so that a hand that moves one does not have
 * all drawn anew. A word waits for the picture that is being drawn of it before it asks for the next.
 */

/** @typedef {import('../../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../../engine/protocol.js').BitmapPatch} BitmapPatch */
/** @typedef {{ document: PageDocument, width: number, keys: string[] }} Sheet */

/** Pictures kept: those of a few pages. */
const MOST = 80;

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{
 *   render: import('../../engine/engine.js').Engine['renderWord'],
 *   onPainted: (document: PageDocument | null) => void, onError: (error: Error & { code?: string }) => void,
 * }} options
 */
export function createWordPainter(canvas, { render, onPainted, onError }) {
  /** By key, oldest first. @type {Map<string, BitmapPatch>} */
  const kept = new Map();
  /** The last picture of each place, shown until the next comes. @type {(BitmapPatch | null)[]} */
  let shown = [];
  /** @type {Set<number>} */
  const running = new Set();
  /** What could not be drawn is not tried again. @type {Set<string>} */
  const failed = new Set();
  /** @type {Sheet | null} */
  let sheet = null;

  return { show, dispose };

  /**
   * @param {PageDocument} document
   * @param {number} width of the page, in pixels of the screen
   */
  function show(document, width) {
    const { words = [], layout, page } = document;
    const same = sheet && sheet.width === width && JSON.stringify([sheet.document.layout, sheet.document.page]) === JSON.stringify([layout, page]);
    // Another page does not show the words of the one before in their old places.
    if (!same || words.length !== sheet?.keys.length) shown = [];
    sheet = { document, width, keys: words.map((word) => JSON.stringify([word, layout, page, width])) };
    words.forEach((_, i) => request(i));
    paint();
  }

  /** @param {number} index */
  function request(index) {
    const now = sheet;
    if (!now || running.has(index) || index >= now.keys.length) return;
    const key = now.keys[index];
    if (kept.has(key) || failed.has(key)) return;
    running.add(index);
    render(now.document, index, now.width).then(
      (patch) => {
        kept.set(key, patch);
        for (const old of [...kept.keys()].slice(0, Math.max(0, kept.size - MOST))) kept.delete(old);
      },
      (error) => {
        failed.add(key);
        if (error.code !== 'cancelled') onError(error);
      },
    ).finally(() => {
      running.delete(index);
      request(index);
      paint();
    });
  }

  function paint() {
    if (!sheet) return;
    const { document, width, keys } = sheet;
    const height = Math.max(1, Math.round(width * document.page.height / document.page.width));
    shown = keys.map((key, i) => kept.get(key) ?? shown[i] ?? null);
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d');
    for (const patch of shown) {
      if (patch) context?.drawImage(patch.bitmap, patch.x, patch.y);
    }
    onPainted(keys.every((key) => kept.has(key) || failed.has(key)) ? document : null);
  }

  function dispose() {
    sheet = null;
    kept.clear();
  }
}
