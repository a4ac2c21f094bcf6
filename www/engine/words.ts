/**
 * Text on pages: a separate wasm module and the glyphs, loaded with the first text. One worker draws text. On the main
 * thread, the same module computes positions during planning. The exports module also draws text, in the export worker
 * (`files.ts`).
 */

import { WORDS_MISSING, loadLetters } from './letters.ts';
import { createPool } from './pool.ts';
import { moduleBytes } from './module-bytes.ts';
import { onceMore } from './once-more.ts';
import { Priority } from './queue.ts';
import { createShaping } from './shaping.ts';
import type { Pool } from './pool.ts';
import type { PageDocument, PhotoMeta, Word, WordBox } from './types.ts';
import type { Call } from './engine.ts';
import { buffersOf } from './protocol.ts';
import type { BitmapPatch, PixelPatch, Wording } from './protocol.ts';

/** Properties of a photo for text placement. */
export type KnownPhoto = Pick<PhotoMeta, 'subjects' | 'mask'>;
export type Lettering = Awaited<ReturnType<ReturnType<typeof createWords>['lettering']>>;

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);
export function createWords() {
  let pool: Pool<Wording> | undefined;

  /**
   * Loads the module for planning: pure functions that take about a millisecond. Rejects with `words-missing`; the next
   * call tries again.
   */
  const { get: lettering } = onceMore(open);

  return { lettering, draw, patches, over, lay, dispose: () => pool?.dispose() };

  function run<Op extends keyof Wording>(
    op: Op,
    args: Wording[Op]['args'],
    call?: Call & { transfer?: Transferable[] },
  ) {
    pool ??= createPool<Wording>({ size: 1, spawn });
    return pool.run({ op, args, priority: Priority.PANEL, ...call });
  }

  /**
   * One text item of a page.
   * @param width of the page, in pixels
   * @param fronts the subjects in front of effects, in the order of `frontsOf`; transferred, as in all functions below
   */
  async function draw(
    document: PageDocument,
    index: number,
    width: number,
    fronts: PixelPatch[],
    call?: Call,
  ): Promise<BitmapPatch> {
    const args = { document: JSON.stringify(document), index, width, fronts };
    return run('word', args, { ...call, transfer: buffersOf(fronts) });
  }

  /** All text items of a page in paint order, as pixels. */
  async function patches(
    document: PageDocument,
    width: number,
    fronts: PixelPatch[],
    call?: Call,
  ): Promise<PixelPatch[]> {
    if (!document.words?.length) return [];
    const args = { document: JSON.stringify(document), width, fronts };
    return run('words', args, { ...call, transfer: buffersOf(fronts) });
  }

  /** The image of a page with its text. */
  async function over(
    document: PageDocument,
    width: number,
    page: BitmapPatch,
    fronts: PixelPatch[],
    call?: Call,
  ): Promise<BitmapPatch> {
    if (!document.words?.length) return page;
    const { bitmap } = page;
    const args = { document: JSON.stringify(document), width, bitmap, fronts };
    return { ...page, bitmap: await run('over', args, { ...call, transfer: [bitmap, ...buffersOf(fronts)] }) };
  }

  /** Draws the text items on the pixels of an opaque page. */
  async function lay(document: PageDocument, width: number, page: PixelPatch, fronts: PixelPatch[], call?: Call) {
    for (const patch of await patches(document, width, fronts, call)) layPixels(page, patch);
    return page;
  }
}

/** @param patch straight alpha; pixels outside the page are ignored */
export function layPixels(page: PixelPatch, patch: PixelPatch) {
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
  const [{ default: init, Lettering }, bytes, table] = await Promise.all([
    import('../pkg-words/inkpanel.js'),
    moduleBytes(MODULE, ...WORDS_MISSING),
    loadLetters(WORDS_MISSING),
  ]);
  await init({ module_or_path: bytes });
  const letters = new Lettering(table);
  const shape = createShaping(letters);
  return {
    /**
     * @param photos properties of photos by id
     * @returns the text items of the document, with automatic items away from faces, and covering as little of bodies
     *   as possible
     */
    settle: (document: PageDocument, photos: Record<string, KnownPhoto>, again = false): Word[] => {
      shape(document);
      return JSON.parse(letters.settle(JSON.stringify(document), JSON.stringify(photos), again));
    },
    /**
     * @param before its earlier bounds
     * @returns the text items of the document, with an automatic item at its earlier place after its text changed; null if
     *   it does not fit there
     */
    stay: (
      document: PageDocument,
      photos: Record<string, KnownPhoto>,
      index: number,
      before: WordBox,
    ): Word[] | null => {
      shape(document);
      const words = letters.stay(JSON.stringify(document), JSON.stringify(photos), index, JSON.stringify(before));
      return words === undefined ? null : JSON.parse(words);
    },
    measure: (document: PageDocument): WordBox[] => {
      shape(document);
      return JSON.parse(letters.measure(JSON.stringify(document)));
    },
    /** @returns whether system fonts draw some of its characters */
    foreign: (text: string): boolean => letters.foreign(text),
    /** @returns the characters of a text without a glyph in a font, each once */
    missing: (text: string, font: string): string => letters.missing(text, font),
  };
}

function spawn() {
  return new Worker(new URL('./word-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-words' });
}
