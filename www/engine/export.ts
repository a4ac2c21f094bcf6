/**
 * Pages at print size. The photos are decoded again from their files, each once a page, by as many workers as there
 * are; one worker puts the panels together and encodes. Many pages are made one after the other: one of A4 takes 35 MB.
 */

import { Priority } from './queue.ts';
import { givesWebp } from './webp.ts';
import type { PageDocument } from './types.ts';
import type { createFiles } from './files.ts';
import type { createPhotos } from './photos.ts';
import type { Run } from './pool.ts';
import type { PixelPatch } from './protocol.ts';
import type { createWords } from './words.ts';

type PanelPatch = PixelPatch & { index: number };
type Call = { signal?: AbortSignal; onProgress?: (done: number, total: number) => void };
type Parts = {
  run: Run;
  photos: ReturnType<typeof createPhotos>;
  words: Pick<ReturnType<typeof createWords>, 'patches'>;
  files: ReturnType<typeof createFiles>;
};

/** What stands on the page of a single panel; its patch brings the rest. */
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
  return { exportPng, exportJpeg, exportWebp, exportPdf, exportPanel };

  async function exportPng(document: PageDocument, call?: Call): Promise<Blob> {
    return whole(document, call, (patches, signal) => encode(document, patches, signal));
  }

  /** @param patches are handed over */
  async function encode(document: PageDocument, patches: PixelPatch[], signal: AbortSignal) {
    const numbered = patches.map((patch, index) => ({ ...patch, index }));
    const args = { document: JSON.stringify(document), width: document.page.width, patches: numbered };
    const transfer = patches.map((patch) => patch.data.buffer);
    return run({ op: 'encode', args, transfer, priority: Priority.PAGE, signal });
  }

  /** @param call `quality` from 1 to 100 */
  async function exportJpeg(document: PageDocument, { quality, ...call }: Call & { quality: number }): Promise<Blob> {
    return whole(document, call, (patches, signal) =>
      files.jpeg(document, document.page, patches, quality, { signal }),
    );
  }

  /** By the browser's encoder; where it has none, without loss, so that `quality` says nothing. */
  async function exportWebp(document: PageDocument, { quality, ...call }: Call & { quality: number }): Promise<Blob> {
    if (!(await givesWebp()))
      return whole(document, call, (patches, signal) =>
        files.losslessWebp(document, document.page, patches, { signal }),
      );
    const png = await exportPng(document, call);
    return files.webp(png, { quality, dpi: document.page.dpi }, call);
  }

  /** @returns one file of all pages */
  async function exportPdf(
    documents: readonly PageDocument[],
    { quality, title, ...call }: Call & { quality: number; title: string },
  ): Promise<Blob> {
    const step = steps(
      documents.reduce((sum, document) => sum + shown(document), 1),
      call.onProgress,
    );
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
   * @returns a PNG
   */
  async function exportPanel(document: PageDocument, index: number, call: Call = {}): Promise<Blob> {
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

  /** @param encode of the panels and the words, in their order */
  async function whole(
    document: PageDocument,
    { signal: stop, onProgress }: Call | undefined = {},
    encode: (patches: PixelPatch[], signal: AbortSignal) => Promise<Blob>,
  ) {
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
   * @param wanted all unless told
   * @param use what becomes of those of one photo
   * @returns in the order of the panels
   */
  async function byPhoto<T extends { index: number }>(
    document: PageDocument,
    wanted: readonly number[] | undefined,
    signal: AbortSignal,
    use: (patches: PanelPatch[]) => Promise<T[]>,
  ): Promise<T[]> {
    const json = JSON.stringify(document);
    const { width } = document.page;
    const parts = await Promise.all(
      [...panelsByPhoto(document, wanted)].map(async ([id, indexes]) => {
        const { file, name } = photos.get(id);
        const args = { id, file, document: json, indexes, width };
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

function steps(total: number, onProgress: Call['onProgress'] = () => {}) {
  let done = 0;
  onProgress(done, total);
  return (count: number) => onProgress((done += count), total);
}

function shown(document: PageDocument) {
  return document.panels.filter((panel) => panel.photo !== null).length;
}

/** @returns the panels that show a photo, by its id */
function panelsByPhoto(document: PageDocument, wanted?: readonly number[]): Map<string, number[]> {
  const groups: Map<string, number[]> = new Map();
  document.panels.forEach(({ photo }, index) => {
    if (photo !== null && (!wanted || wanted.includes(index))) groups.set(photo, [...(groups.get(photo) ?? []), index]);
  });
  return groups;
}
