/** Thumbnails of the project list, drawn in idle time after a page was saved. */

import { Priority } from '../engine/queue.ts';
import type { PageDocument } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Database } from './database.ts';

/** Milliseconds after the last saving. */
const LATER = 1_500;
/** Pixels. */
const WIDTH = 320;

export function createPictures({
  store,
  engine,
  database,
  onDrawn,
}: {
  store: Store;
  engine: Pick<Engine, 'renderPage' | 'hasPhoto'>;
  database: () => Promise<Database>;
  onDrawn: () => void;
}) {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let drawn: unknown = null;

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

  async function drawingOf(page: PageDocument) {
    const { bitmap } = await engine.renderPage(page, WIDTH, { priority: Priority.REST });
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(bitmap);
    return canvas.convertToBlob({ type: 'image/webp', quality: 0.8 });
  }
}
