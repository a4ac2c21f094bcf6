// @ts-check
/** The thumbnails in the list of projects: drawn a while after the page was saved, when nobody waits for anything. */

import { Priority } from '../../engine/queue.js';

/** Milliseconds after the last saving. */
const LATER = 1_500;
/** Pixels. */
const WIDTH = 320;

/**
 * @param {{
 *   store: import('../store.js').Store,
 *   engine: Pick<import('../../engine/engine.js').Engine, 'renderPage' | 'hasPhoto'>,
 *   database: () => Promise<import('./database.js').Database>, onDrawn: () => void,
 * }} app
 */
export function createPictures({ store, engine, database, onDrawn }) {
  /** @type {any} */
  let timer;
  /** @type {unknown} */
  let drawn = null;

  return { later };

  /** Draws the page if it is another than the one drawn last. */
  function later() {
    clearTimeout(timer);
    timer = setTimeout(() => void draw().catch(() => {}), LATER);
  }

  async function draw() {
    const page = store.page.peek();
    const { id } = store.place.peek();
    if (!page || page === drawn || store.reading.peek()) return;
    const picture = await drawingOf(page);
    const all = (await database()).transaction('projects', 'readwrite');
    const project = await all.store.get(id);
    if (project) await all.store.put({ ...project, picture });
    await all.done;
    drawn = page;
    onDrawn();
  }

  /** @param {import('../project.js').PageDocument} page */
  async function drawingOf(page) {
    const { bitmap } = await engine.renderPage(page, WIDTH, { priority: Priority.REST });
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(bitmap);
    return canvas.convertToBlob({ type: 'image/webp', quality: 0.8 });
  }
}
