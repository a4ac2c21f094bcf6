/**
 * The calls that draw with photos of the album: panels, whole pages, thumbnails of styles.
 */

import { panelOf } from './figures.ts';
import { Priority } from './queue.ts';
import type { PageDocument } from './types.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Run } from './pool.ts';
import type { BitmapPatch, Explored, PhotoHandle, PixelPatch } from './protocol.ts';
import type { createWords } from './words.ts';

export function createRenders({
  run,
  photos,
  words,
}: {
  run: Run;
  photos: ReturnType<typeof createPhotos>;
  words: ReturnType<typeof createWords>;
}) {
  return { renderPanel, renderWord: words.draw, renderPage, composePixels, stylePhoto, exploreStyles };

  /**
   * One panel of a page.
   * @param width of the page, in pixels
   */
  async function renderPanel(
    document: PageDocument,
    index: number,
    width: number,
    { tier = 'work', ...call }: Call & { tier?: 'small' | 'work' } = {},
  ): Promise<BitmapPatch> {
    const shows = document.panels[panelOf(document, index)].photo;
    const needed = photos.handles([shows], tier);
    const args = { document: JSON.stringify(document), index, width, tier, photos: needed };
    const photo = photos.names([shows]);
    return run({ op: 'panel', args, photo, holds: keys(needed), priority: Priority.PANEL, ...call });
  }

  /** A whole page as one bitmap: thumbnails. */
  async function renderPage(document: PageDocument, width: number, call?: Call): Promise<BitmapPatch> {
    const page = await run({ op: 'page', ...pageJob(document, width, 'small'), priority: Priority.VIEW, ...call });
    return words.over(document, width, page, call);
  }

  /** A whole page as pixels. */
  async function composePixels(document: PageDocument, width: number, call?: Call): Promise<PixelPatch> {
    const page = await run({ op: 'compose', ...pageJob(document, width, 'work'), priority: Priority.PAGE, ...call });
    return words.lay(document, width, page, call);
  }

  /** A crop of a photo in some style: thumbnails. */
  async function stylePhoto(
    id: string,
    style: string | object,
    {
      width,
      height,
      crop = null,
      tier = 'small',
    }: { width: number; height: number; crop?: object | null; tier?: 'small' | 'work' },
    call?: Call,
  ): Promise<BitmapPatch> {
    const [photo] = photos.handles([id], tier);
    const args = { photo, style: JSON.stringify(style), width, height, crop: crop ? JSON.stringify(crop) : '' };
    return run({
      op: 'stylePhoto',
      args,
      photo: photos.names([id]),
      holds: [photo.key],
      priority: Priority.VIEW,
      ...call,
    });
  }

  /** A photo in many styles, with what is known of each picture. */
  async function exploreStyles(
    id: string,
    styles: object[],
    { width, height }: { width: number; height: number },
    call?: Call,
  ): Promise<Explored[]> {
    const [photo] = photos.handles([id], 'small');
    const args = { photo, styles: styles.map((style) => JSON.stringify(style)), width, height };
    return run({
      op: 'explore',
      args,
      photo: photos.names([id]),
      holds: [photo.key],
      priority: Priority.REST,
      ...call,
    });
  }

  function pageJob(document: PageDocument, width: number, tier: 'small' | 'work') {
    const ids = document.panels.map((panel) => panel.photo);
    const needed = photos.handles(ids, tier);
    return {
      args: { document: JSON.stringify(document), width, tier, photos: needed },
      photo: photos.names(ids),
      holds: keys(needed),
    };
  }
}

function keys(handles: PhotoHandle[]) {
  return handles.map(({ key }) => key);
}

/** @returns the name of a file, or `other` for a Blob without one */
export function nameOf(blob: Blob, other: string): string {
  return 'name' in blob && typeof blob.name === 'string' ? blob.name : other;
}
