/**
 * Pages at print size. The photos are decoded again from their files, each once a page, by as many workers as there
 * are; one worker puts the panels together and encodes.
 */

import { byPanel, frontPictures, panelOf, picturesOf } from './figures.ts';
import { rotatedFile } from './metadata/rotate.ts';
import { Priority } from './queue.ts';
import { givesWebp } from './webp.ts';
import { overlapped } from './overlap.ts';
import { buffersOf, failure } from './protocol.ts';
import type { Rotation } from './metadata/rotate.ts';
import type { PageDocument, PdfOptions } from './types.ts';
import type { createFiles } from './files.ts';
import type { createPhotos } from './photos.ts';
import type { Run } from './pool.ts';
import type { Picture, PixelPatch, Plates, Rgb } from './protocol.ts';
import type { createWords } from './words.ts';

type PanelPatch = PixelPatch & { index: number };
/** `bordered`: with panel borders, which a PDF file has as vectors. */
type Drawn = { signal: AbortSignal; bordered?: boolean };
type Call = { signal?: AbortSignal; onProgress?: (done: number, total: number) => void };
/** `quality` from 1 to 100; `alts`: alternative texts of the panels of each page. */
type PdfCall = Call & { quality: number; title: string; alts?: readonly (readonly string[])[]; options?: PdfOptions };
type Parts = {
  run: Run;
  photos: ReturnType<typeof createPhotos>;
  words: Pick<ReturnType<typeof createWords>, 'patches'>;
  files: ReturnType<typeof createFiles>;
};

/** Marks a panel without a photo. */
const EMPTY = '';

/** The mask of a photo that is all subject. */
const ALL = '1x1:p';

/** The page of a single panel. Its patch contains everything. */
const ALONE = {
  layout: 'grid-2',
  panels: [
    { photo: null, crop: null },
    { photo: null, crop: null },
  ],
  merges: [],
  words: [],
};

export function createExports({ run, photos, words, files }: Parts) {
  return { exportPng, exportJpeg, exportWebp, exportPdf, exportPlates, exportPanel, exportSubject, rotatedPhoto };

  async function exportPng(document: PageDocument, call?: Call): Promise<Blob> {
    return whole(document, call, (patches, signal) => encode(document, patches, signal));
  }

  /** @param patches are handed over */
  async function encode(document: PageDocument, patches: PixelPatch[], signal: AbortSignal) {
    const numbered = patches.map((patch, index) => ({ ...patch, index }));
    const args = { document: JSON.stringify(document), width: document.page.width, patches: numbered };
    const transfer = buffersOf(patches);
    return run({ op: 'encode', args, transfer, priority: Priority.PAGE, signal });
  }

  /** @param call `quality` from 1 to 100 */
  async function exportJpeg(document: PageDocument, { quality, ...call }: Call & { quality: number }): Promise<Blob> {
    return whole(document, call, (patches, signal) =>
      files.jpeg(document, document.page, patches, quality, { signal }),
    );
  }

  /** Encodes with the browser. If it has no encoder, the file is lossless and `quality` is ignored. */
  async function exportWebp(document: PageDocument, { quality, ...call }: Call & { quality: number }): Promise<Blob> {
    if (!(await givesWebp()))
      return whole(document, call, (patches, signal) =>
        files.losslessWebp(document, document.page, patches, { signal }),
      );
    const png = await exportPng(document, call);
    return files.webp(png, { quality, dpi: document.page.dpi }, call);
  }

  /**
   * @param call `options`: how it is printed
   * @returns one file of all pages
   */
  async function exportPdf(
    documents: readonly PageDocument[],
    { quality, title, alts = [], options, ...call }: PdfCall,
  ): Promise<Blob> {
    const step = stepsOf(documents, call);
    return stoppable(call.signal, async (signal) => {
      const pages = await overlapped(documents, async (document, i) => {
        const made = await pictures(document, { quality, inks: [], signal, step });
        return { document, alts: alts[i] ?? [], pictures: made };
      });
      const pdf = await files.pdf(pages, { ...options, title }, { signal });
      step(1);
      return pdf;
    });
  }

  /**
   * @param documents pages of one style, which prints with inks
   * @param call as of `exportPdf`
   * @returns a gray file of all pages for each ink
   */
  async function exportPlates(
    documents: readonly PageDocument[],
    { quality, title, alts = [], options, ...call }: PdfCall,
  ): Promise<{ ink: string; blob: Blob }[]> {
    const step = stepsOf(documents, call);
    return stoppable(call.signal, async (signal) => {
      let inks: Plates['inks'] = [];
      const pages = await overlapped(documents, async (page, i) => {
        const args = { document: JSON.stringify(page) };
        const found = await run({ op: 'plates', args, priority: Priority.PAGE, signal });
        if (!found || (inks.length > 0 && JSON.stringify(found.inks) !== JSON.stringify(inks)))
          throw failure('no-plates', 'The pages are not all printed with the same inks.');
        ({ inks } = found);
        const { document } = found;
        const made = await pictures(document, { quality, inks: coloursOf(inks), signal, step });
        return { document, alts: alts[i] ?? [], pictures: made };
      });
      const plates = [];
      for (const [plate, { name }] of inks.entries()) {
        const own = pages.map((page) => ({
          ...page,
          pictures: page.pictures.filter((picture) => picture.plate === plate),
        }));
        const how = { ...options, title, plate, inks: coloursOf(inks) };
        plates.push({ ink: name, blob: await files.pdf(own, how, { signal }) });
      }
      step(1);
      return plates;
    });
  }

  /** The panels of a page as a PDF file has them. */
  async function pictures(
    document: PageDocument,
    {
      signal,
      step,
      ...wish
    }: { quality: number; inks: readonly Rgb[]; signal: AbortSignal; step: (count: number) => void },
  ): Promise<Picture[]> {
    const made = async (patches: PanelPatch[]) => {
      const count = patches.length;
      const cut = await files.pictures(document, patches, wish, { signal });
      step(count);
      return cut;
    };
    const wanted = [...withPhoto(document), ...frontsWithPhoto(document)];
    return byPhoto(document, wanted, { signal, bordered: false }, made);
  }

  /**
   * One panel with its text, in its size on the page. Panels that are not rectangles have the page background.
   * @returns a PNG
   */
  async function exportPanel(document: PageDocument, index: number, call: Call = {}): Promise<Blob> {
    const step = steps(2, call.onProgress);
    return stoppable(call.signal, async (signal) => {
      const own = { ...document, words: document.words?.filter((word) => word.panel === index) };
      const wanted = [index, ...frontPictures(own)];
      const [panel, ...fronts] = await byPhoto(own, wanted, { signal }, async (patches) => patches);
      step(1);
      const written = await words.patches(own, document.page.width, fronts, { signal });
      const { x, y, width, height } = panel;
      // The panel's rectangle becomes a page, and all patches move left and up.
      const page = { ...document.page, width, height };
      const moved = [panel, ...written].map((patch) => ({ ...patch, x: patch.x - x, y: patch.y - y }));
      const png = await encode({ ...document, ...ALONE, page }, moved, signal);
      step(1);
      return png;
    });
  }

  /**
   * The isolated subject of a photo, at the photo's own size.
   * @param mask its subject mask
   * @returns a PNG with alpha
   */
  async function exportSubject(id: string, mask: string, { signal, onProgress }: Call = {}): Promise<Blob> {
    const step = steps(1, onProgress);
    const { file, name } = photos.get(id);
    const png = await run({ op: 'cutOut', args: { id, file, mask }, photo: name, priority: Priority.PAGE, signal });
    step(1);
    return png;
  }

  /**
   * @returns the file of a photo, rotated or flipped. It is lossless; a file whose format has no orientation becomes a
   *   PNG
   */
  async function rotatedPhoto(id: string, rotation: Rotation): Promise<Blob> {
    const { file } = photos.get(id);
    const rotated = (await rotatedFile(file, rotation)) ?? (await rotatedFile(await exportSubject(id, ALL), rotation));
    if (!rotated) throw failure('damaged', 'The photo cannot be rotated.');
    return rotated;
  }

  /** @param encode of panels and text items, in order */
  async function whole(
    document: PageDocument,
    { signal: stop, onProgress }: Call | undefined = {},
    encode: (patches: PixelPatch[], signal: AbortSignal) => Promise<Blob>,
  ) {
    // Encoding counts as one step.
    const { length } = picturesOf(document);
    const all = [...picturesOf(document), ...frontPictures(document)];
    const step = steps(all.length + 1, onProgress);
    return stoppable(stop, async (signal) => {
      // Panels without a photo, too: empty frames, as a PDF file has them.
      const drawn = await byPhoto(document, all, { signal }, async (patches) => {
        step(patches.length);
        return patches;
      });
      const [panels, fronts] = [drawn.slice(0, length), drawn.slice(length)];
      const written = await words.patches(document, document.page.width, fronts, { signal });
      const file = await encode([...panels, ...written], signal);
      step(1);
      return file;
    });
  }

  /**
   * Draws panels from the original files, grouped by photo.
   * @param use receives the panels of one photo
   * @returns in the order of the panels
   */
  async function byPhoto<T extends { index: number }>(
    document: PageDocument,
    wanted: readonly number[],
    { signal, bordered = true }: Drawn,
    use: (patches: PanelPatch[]) => Promise<T[]>,
  ): Promise<T[]> {
    const json = JSON.stringify(document);
    const { width } = document.page;
    const parts = await Promise.all(
      [...panelsByPhoto(document, wanted)].map(async ([id, pictures]) => {
        const { file, name } = id === EMPTY ? { file: null, name: '' } : photos.get(id);
        const panels = byPanel(document, pictures);
        const args = { id, file, mask: photos.maskOf(id), document: json, panels, width, bordered };
        return use(await run({ op: 'fullPanels', args, photo: name, priority: Priority.PAGE, signal }));
      }),
    );
    return parts.flat().sort((a, b) => a.index - b.index);
  }
}

/** @param work whose first failure stops the rest */
async function stoppable<T>(signal: AbortSignal | undefined, work: (signal: AbortSignal) => Promise<T>) {
  const stop = new AbortController();
  try {
    return await work(signal ? AbortSignal.any([signal, stop.signal]) : stop.signal);
  } finally {
    stop.abort();
  }
}

function coloursOf(inks: Plates['inks']): Rgb[] {
  return inks.map(({ rgb }) => rgb);
}

function steps(total: number, onProgress: Call['onProgress'] = () => {}) {
  let done = 0;
  onProgress(done, total);
  return (count: number) => onProgress((done += count), total);
}

/** Progress of the panels with photos of all pages, and of the file. */
function stepsOf(documents: readonly PageDocument[], { onProgress }: Call) {
  return steps(
    documents.reduce((sum, document) => sum + withPhoto(document).length + frontsWithPhoto(document).length, 1),
    onProgress,
  );
}

/** @returns the photo of a panel's image; merged panels show the photo of the first */
function photoOf(document: PageDocument, picture: number): string {
  const { panels, merges } = document;
  const index = panelOf(document, picture);
  const leader = merges.find((group) => group.includes(index))?.[0] ?? index;
  return panels[leader]?.photo ?? EMPTY;
}

/** @returns the pictures that show one */
function withPhoto(document: PageDocument): number[] {
  return picturesOf(document).filter((index) => photoOf(document, index) !== EMPTY);
}

/** @returns the fronts that show one */
function frontsWithPhoto(document: PageDocument): number[] {
  return frontPictures(document).filter((index) => photoOf(document, index) !== EMPTY);
}

/** @returns pictures by the id of their photo */
function panelsByPhoto(document: PageDocument, wanted: readonly number[]): Map<string, number[]> {
  const groups: Map<string, number[]> = new Map();
  for (const index of wanted) {
    const photo = photoOf(document, index);
    groups.set(photo, [...(groups.get(photo) ?? []), index]);
  }
  return groups;
}
