/**
 * The export worker. It loads its wasm module with the first job, and the glyphs for files with text. It uses the
 * browser's WebP encoder if available.
 */

import initFiles, {
  AnimaticPlan,
  Book,
  boardSheets,
  Cut,
  comicFile,
  stripPages,
  Lettering,
  losslessPicture as losslessFile,
  Plate,
  Print,
  shotFile,
} from '../pkg-exports/inkpanel.js';
import { blobOf } from './blobs.ts';
import { loadLetters } from './letters.ts';
import { moduleBytes } from './module-bytes.ts';
import { failure } from './protocol.ts';
import { serveJobs } from './serving.ts';
import { createShaping } from './shaping.ts';
import { withDpi } from './webp.ts';
import type { Making, Picture, PixelPatch } from './protocol.ts';
import type { MotionRequest, StripRequest } from './types.ts';
import type { Work } from './serving.ts';

/** Errors if the module or the glyphs could not be loaded. */
const MISSING = [
  'files-missing',
  'The part of the program that makes this kind of file could not be loaded. Try again, or save a PNG.',
] as const;

const MODULE = new URL('../pkg-exports/inkpanel_bg.wasm', import.meta.url);

type Args<Op extends keyof Making> = Making[Op]['args'];

let started: Promise<WebAssembly.Memory> | undefined;
let table: Uint8Array | undefined;

const OPERATIONS: Work<Making> = {
  jpeg,
  webp,
  losslessWebp,
  losslessPicture,
  pictures,
  pdf,
  comic,
  board,
  strip,
  shots,
  animatic,
  motion,
};

serveJobs<Making>(async (op, args, slow) => {
  // WebP is the browser's own work.
  if (op !== 'webp') started ??= start();
  const memory = await started;
  const answer = await OPERATIONS[op](args, slow);
  return { ...answer, memory: memory?.buffer.byteLength ?? 0 };
});

/** After an error, the next job tries again. */
async function start() {
  try {
    const { memory } = await initFiles({ module_or_path: await moduleBytes(MODULE, ...MISSING) });
    return memory;
  } catch (error) {
    started = undefined;
    throw error;
  }
}

/** The glyphs of one file, with separate traced glyphs. */
async function lettering() {
  table ??= await loadLetters(MISSING);
  return new Lettering(table);
}

async function jpeg({ document, size, patches, quality }: Args<'jpeg'>) {
  const bytes = printed(document, size, patches, (print) => print.jpeg(quality));
  return { ok: await blobOf(bytes, { type: 'image/jpeg' }), transfer: [] };
}

async function losslessWebp({ document, size, patches, dpi }: Args<'losslessWebp'>) {
  const bytes = printed(document, size, patches, (print) => print.webp());
  return { ok: withDpi(bytes, { ...size, dpi }), transfer: [] };
}

async function losslessPicture({ width, height, data }: Args<'losslessPicture'>) {
  const ok = losslessFile(width, height, bytesOf(data)) as Uint8Array<ArrayBuffer>;
  return { ok, transfer: [ok.buffer] };
}

/** @param encode returns the file of the page with all patches */
function printed(
  document: string,
  size: { width: number; height: number },
  patches: PixelPatch[],
  encode: (print: Print) => Uint8Array,
) {
  const print = new Print(document, size.width, size.height);
  try {
    for (const { x, y, width, height, data } of patches) print.lay(x, y, width, height, bytesOf(data));
    return encode(print) as Uint8Array<ArrayBuffer>;
  } finally {
    print.free();
  }
}

async function webp({ picture, quality, dpi }: Args<'webp'>) {
  const bitmap = await createImageBitmap(picture);
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  (canvas.getContext('2d') as OffscreenCanvasRenderingContext2D).drawImage(bitmap, 0, 0);
  bitmap.close();
  const made = await canvas.convertToBlob({ type: 'image/webp', quality: quality / 100 });
  if (made.type !== 'image/webp')
    throw failure('no-webp', 'This browser cannot create WebP files. Choose PNG or JPEG.');
  const { width, height } = canvas;
  return { ok: withDpi(new Uint8Array(await made.arrayBuffer()), { width, height, dpi }), transfer: [] };
}

/** @param args `inks`: each panel has a separate image for each of them; null for one in colour */
async function pictures({ document, patches, quality, inks }: Args<'pictures'>) {
  const ok: Picture[] = [];
  const colours = Uint8Array.from(inks.flat());
  for (let ink = 0; ink < Math.max(1, inks.length); ink += 1) {
    const plate = inks.length > 0 ? new Plate(colours, ink) : null;
    try {
      for (const { index, x, y, width, height, data } of patches) {
        const rgba = bytesOf(data);
        const cut = plate
          ? plate.cut(document, index, x, y, width, height, rgba, quality)
          : new Cut(document, index, x, y, width, height, rgba, quality);
        const made = cut.take() as Uint8Array<ArrayBuffer>;
        const alpha = cut.take_alpha() as Uint8Array<ArrayBuffer> | undefined;
        const place = { x: cut.x, y: cut.y, width: cut.width, height: cut.height };
        cut.free();
        ok.push({ index, ...place, jpeg: made, ...(alpha && { alpha }), ...(plate && { plate: ink }) });
      }
    } finally {
      plate?.free();
    }
  }
  return { ok, transfer: ok.flatMap(({ jpeg: file, alpha }) => (alpha ? [file.buffer, alpha.buffer] : [file.buffer])) };
}

async function pdf({ pages, options }: Args<'pdf'>) {
  const letters = await lettering();
  const book = new Book();
  const shape = createShaping(letters);
  try {
    for (const page of pages) {
      shape(JSON.parse(page.document));
      book.add_page(page.document, JSON.stringify(page.alts));
      for (const { index, x, y, width, height, jpeg: bytes, alpha } of page.pictures)
        book.add_picture(index, x, y, width, height, bytes, alpha);
    }
    const bytes = book.finish(letters, JSON.stringify(options)) as Uint8Array<ArrayBuffer>;
    return { ok: await blobOf(bytes, { type: 'application/pdf' }), transfer: [] };
  } finally {
    book.free();
    letters.free();
  }
}

/** The text of a comic; its pictures are put in where they are. */
async function comic({ kind, comic: told }: Args<'comic'>) {
  const letters = await lettering();
  try {
    return { ok: comicFile(kind, told, letters), transfer: [] };
  } finally {
    letters.free();
  }
}

async function board({ request }: Args<'board'>) {
  return { ok: boardSheets(request), transfer: [] };
}

async function strip({ request }: Args<'strip'>) {
  const letters = await lettering();
  const { pages } = JSON.parse(request) as StripRequest;
  const shape = createShaping(letters);
  try {
    for (const page of pages) shape(page);
    return { ok: stripPages(request, letters), transfer: [] };
  } finally {
    letters.free();
  }
}

async function shots({ ending, list }: Args<'shots'>) {
  return { ok: shotFile(ending, list), transfer: [] };
}

async function animatic({ request }: Args<'animatic'>) {
  return laidOut(new AnimaticPlan(request));
}

async function motion({ request }: Args<'motion'>) {
  const letters = await lettering();
  const { pages } = JSON.parse(request) as MotionRequest;
  const shape = createShaping(letters);
  try {
    for (const page of pages) shape(page);
    return laidOut(AnimaticPlan.pages(request, letters));
  } finally {
    letters.free();
  }
}

function laidOut(plan: AnimaticPlan) {
  try {
    const table = plan.table() as Float32Array<ArrayBuffer>;
    return { ok: { plan: plan.json(), table }, transfer: [table.buffer] };
  } finally {
    plan.free();
  }
}

function bytesOf(data: Uint8ClampedArray<ArrayBuffer>) {
  return new Uint8Array(data.buffer, data.byteOffset, data.length);
}
