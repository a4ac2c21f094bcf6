/**
 * Files that the core does not make: JPEG, WebP and PDF. They have a separate worker and module, loaded with the first
 * export, so that text on the screen does not wait for an export.
 */

import { createPool } from './pool.ts';
import { buffersOf } from './protocol.ts';
import { Priority } from './queue.ts';
import type {
  Animatic,
  AnimaticRequest,
  BoardRequest,
  Comic,
  ComicFile,
  MotionRequest,
  PageDocument,
  PdfOptions,
  Piece,
  ShotList,
  StripRequest,
} from './types.ts';
import type { Pool } from './pool.ts';
import type { ComicKind, ListKind, Making, Picture, PixelPatch, Rgb } from './protocol.ts';

type Call = { signal?: AbortSignal };

export type { Picture };

export function createFiles() {
  let pool: Pool<Making> | undefined;

  return {
    jpeg,
    webp,
    losslessWebp,
    losslessPicture,
    pictures,
    pdf,
    comicPieces,
    comicFiles,
    boardSheets,
    stripPages,
    shotFile,
    animatic,
    motion,
    dispose: () => pool?.dispose(),
  };

  function run<Op extends keyof Making>(op: Op, args: Making[Op]['args'], transfer: Transferable[], call?: Call) {
    pool ??= createPool<Making>({ size: 1, spawn });
    return pool.run({ op, args, transfer, priority: Priority.PAGE, ...call });
  }

  /**
   * Encodes a page from its patches.
   * @param size in pixels
   * @param patches are handed over
   * @param quality from 1 to 100
   */
  async function jpeg(
    document: PageDocument,
    { width, height }: { width: number; height: number },
    patches: PixelPatch[],
    quality: number,
    call?: Call,
  ): Promise<Blob> {
    return run(
      'jpeg',
      { document: JSON.stringify(document), size: { width, height }, patches, quality },
      buffersOf(patches),
      call,
    );
  }

  /**
   * @param picture that the browser can read
   * @param wish `quality` from 1 to 100
   */
  async function webp(picture: Blob, { quality, dpi }: { quality: number; dpi: number }, call?: Call): Promise<Blob> {
    return run('webp', { picture, quality, dpi }, [], call);
  }

  /**
   * Encodes a page from its patches without loss, for browsers without a WebP encoder.
   * @param size in pixels
   * @param patches are handed over
   */
  async function losslessWebp(
    document: PageDocument,
    { width, height }: { width: number; height: number },
    patches: PixelPatch[],
    call?: Call,
  ): Promise<Blob> {
    return run(
      'losslessWebp',
      { document: JSON.stringify(document), size: { width, height }, patches, dpi: document.page.dpi },
      buffersOf(patches),
      call,
    );
  }

  /** Encodes an image with alpha as a lossless WebP file. @param picture is transferred */
  async function losslessPicture(
    picture: Making['losslessPicture']['args'],
    call?: Call,
  ): Promise<Uint8Array<ArrayBuffer>> {
    return run('losslessPicture', picture, buffersOf([picture]), call);
  }

  /**
   * Panels as a PDF file has them.
   * @param patches panels drawn without borders at full width; they are handed over
   * @param wish `quality` from 1 to 100; `inks`: one image for each ink, or one in colours
   */
  async function pictures(
    document: PageDocument,
    patches: (PixelPatch & { index: number })[],
    { quality, inks = [] }: { quality: number; inks?: readonly Rgb[] },
    call?: Call,
  ): Promise<Picture[]> {
    const args = { document: JSON.stringify(document), patches, quality, inks };
    return run('pictures', args, buffersOf(patches), call);
  }

  /** the images are transferred */
  async function pdf(
    pages: { document: PageDocument; alts: readonly string[]; pictures: Picture[] }[],
    options: PdfOptions,
    call?: Call,
  ): Promise<Blob> {
    const args = { options, pages: pages.map((page) => ({ ...page, document: JSON.stringify(page.document) })) };
    return run(
      'pdf',
      args,
      pages.flatMap((page) => page.pictures.map((picture) => picture.jpeg.buffer)),
      call,
    );
  }

  /**
   * @returns the pieces of an HTML file with a reader: text, and indices of pages whose images are inserted as data
   *   URLs
   */
  async function comicPieces(comic: Comic, call?: Call): Promise<Piece[]> {
    return JSON.parse(await comicText('html', comic, call));
  }

  /** @returns the files of an EPUB book or a comic archive, in their order */
  async function comicFiles(kind: Exclude<ComicKind, 'html'>, comic: Comic, call?: Call): Promise<ComicFile[]> {
    return JSON.parse(await comicText(kind, comic, call));
  }

  /** @returns the sheets of a board */
  async function boardSheets(request: BoardRequest, call?: Call): Promise<PageDocument[]> {
    return JSON.parse(await run('board', { request: JSON.stringify(request) }, [], call));
  }

  /** @returns the pages of a vertical strip */
  async function stripPages(request: StripRequest, call?: Call): Promise<PageDocument[]> {
    return JSON.parse(await run('strip', { request: JSON.stringify(request) }, [], call));
  }

  /** @returns the text of a list of shots */
  async function shotFile(ending: ListKind, list: ShotList, call?: Call): Promise<string> {
    return run('shots', { ending, list: JSON.stringify(list) }, [], call);
  }

  /** the timed shots, and the content of each frame (`Animatic::table` of the core) */
  async function animatic(request: AnimaticRequest, call?: Call): Promise<{ plan: Animatic; table: Float32Array }> {
    return laidOut('animatic', request, call);
  }

  /** pages as a motion comic */
  async function motion(request: MotionRequest, call?: Call): Promise<{ plan: Animatic; table: Float32Array }> {
    return laidOut('motion', request, call);
  }

  async function laidOut(op: 'animatic' | 'motion', request: AnimaticRequest | MotionRequest, call?: Call) {
    const { plan, table } = await run(op, { request: JSON.stringify(request) }, [], call);
    return { plan: JSON.parse(plan) as Animatic, table };
  }

  function comicText(kind: ComicKind, comic: Comic, call?: Call) {
    return run('comic', { kind, comic: JSON.stringify(comic) }, [], call);
  }
}

function spawn() {
  return new Worker(new URL('./file-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-files' });
}
