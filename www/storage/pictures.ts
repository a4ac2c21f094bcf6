/** Thumbnails of the project list: the first page, drawn in idle time after a page was saved. */

import { Priority } from '../engine/queue.ts';
import type { PageDocument } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Database } from './database.ts';

/** Minimum milliseconds after the last saving. */
const DELAY = 1_500;
/** Pixels. */
const WIDTH = 320;

export function createPictures({
  store,
  engine,
  scheduler,
  database,
  onDrawn,
}: {
  store: Store;
  engine: Pick<Engine, 'renderPage'>;
  scheduler: Pick<Scheduler, 'background'>;
  database: () => Promise<Database>;
  onDrawn: () => void;
}) {
  let stop = new AbortController();
  let drawn: unknown = null;

  return { later };

  /** Draws the first page if it is another than the one drawn last. */
  function later() {
    stop.abort();
    stop = new AbortController();
    scheduler.background(() => draw().catch(() => {}), { delay: DELAY, signal: stop.signal });
  }

  async function draw() {
    const page = store.sheets.peek().at(0);
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
