/**
 * Rendering calls that need photos of the album: panels, whole pages, thumbnails of styles.
 */

import { bmp } from './bmp.ts';
import { frontPictures, frontsOf, panelOf, standsBehind } from './figures.ts';
import { Priority } from './queue.ts';
import type { PageDocument, Word } from './types.ts';
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
  return {
    renderPanel,
    renderPictures,
    renderWord,
    renderPage,
    pageFile,
    composePixels,
    stylePhoto,
    photoFile,
    exploreStyles,
  };

  /**
   * One panel of a page.
   * @param width of the page, in pixels
   */
  async function renderPanel(
    document: PageDocument,
    index: number,
    width: number,
    call?: Call & { tier?: 'small' | 'work' },
  ): Promise<BitmapPatch> {
    return (await renderPictures(document, [index], width, call))[0];
  }

  /**
   * A panel with its breakout, or only one of the two. The pixels are equal in both cases.
   * @param pictures of one panel
   * @param width of the page, in pixels
   */
  async function renderPictures(
    document: PageDocument,
    pictures: readonly number[],
    width: number,
    { tier = 'work', ...call }: Call & { tier?: 'small' | 'work' } = {},
  ): Promise<BitmapPatch[]> {
    return run({ op: 'panel', ...panelJob(document, pictures, width, tier), priority: Priority.PANEL, ...call });
  }

  /**
   * One text item of a page.
   * @param width of the page, in pixels
   */
  async function renderWord(document: PageDocument, index: number, width: number, call?: Call): Promise<BitmapPatch> {
    // Other text items have nothing in front.
    const own = standsBehind(document.words?.[index] as Word);
    const alone = { ...document, words: own === null ? [] : [document.words?.[index] as Word] };
    const fronts = await frontsFor(alone, width, 'work', call);
    return words.draw(fronts.length > 0 ? alone : document, fronts.length > 0 ? 0 : index, width, fronts, call);
  }

  /** Subjects in front of the effects of a page. Photos that are not loaded are skipped. */
  async function frontsFor(
    document: PageDocument,
    width: number,
    tier: 'small' | 'work',
    call?: Call,
  ): Promise<PixelPatch[]> {
    const there = frontsOf(document).every((panel) => photos.has(shownBy(document, panel) ?? ''));
    if (!there) return [];
    const front = (index: number) =>
      run({ op: 'front', ...panelJob(document, [index], width, tier), priority: Priority.PANEL, ...call });
    return (await Promise.all(frontPictures(document).map(front))).flat();
  }

  /** Renders a whole page as one bitmap, for thumbnails. */
  async function renderPage(document: PageDocument, width: number, call?: Call): Promise<BitmapPatch> {
    const page = await run({ op: 'page', ...pageJob(document, width, 'small'), priority: Priority.VIEW, ...call });
    return words.over(document, width, page, await frontsFor(document, width, 'small', call), call);
  }

  /** Renders a whole page as a file that an image element shows, for thumbnails in lists. */
  async function pageFile(document: PageDocument, width: number, call?: Call): Promise<Blob> {
    const job = pageJob(document, width, 'small');
    const page = await run({ op: 'compose', ...job, priority: Priority.VIEW, ...call });
    return fileOf(await words.lay(document, width, page, await frontsFor(document, width, 'small', call), call));
  }

  /** Renders a whole page as pixels. */
  async function composePixels(document: PageDocument, width: number, call?: Call): Promise<PixelPatch> {
    const page = await run({ op: 'compose', ...pageJob(document, width, 'work'), priority: Priority.PAGE, ...call });
    return words.lay(document, width, page, await frontsFor(document, width, 'work', call), call);
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

  /** A photo in some style as a file that an image element shows, for thumbnails in lists. */
  async function photoFile(
    id: string,
    style: string | object,
    { width, height }: { width: number; height: number },
    call?: Call,
  ): Promise<Blob> {
    const [photo] = photos.handles([id], 'small');
    const args = { photo, style: JSON.stringify(style), width, height };
    const job = { photo: photos.names([id]), holds: [photo.key] };
    return fileOf(await run({ op: 'stylePixels', args, ...job, priority: Priority.VIEW, ...call }));
  }

  /** A photo in many styles, with properties of each image. */
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

  function panelJob(document: PageDocument, pictures: readonly number[], width: number, tier: 'small' | 'work') {
    const shows = shownBy(document, panelOf(document, pictures[0]));
    const needed = photos.handles([shows], tier);
    return {
      args: { document: JSON.stringify(document), pictures: [...pictures], width, tier, photos: needed },
      photo: photos.names([shows]),
      holds: keys(needed),
    };
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

/** @returns the photo of a panel; merged panels have the photo of the first */
function shownBy({ panels, merges }: PageDocument, panel: number): string | null {
  return panels[merges.find((group) => group.includes(panel))?.[0] ?? panel].photo;
}

function keys(handles: PhotoHandle[]) {
  return handles.map(({ key }) => key);
}

function fileOf(pixels: PixelPatch): Blob {
  return new Blob([bmp(pixels)], { type: 'image/bmp' });
}

/** @returns the name of a file, or `other` for a Blob without one */
export function nameOf(blob: Blob, other: string): string {
  return 'name' in blob && typeof blob.name === 'string' ? blob.name : other;
}
