/** The worker that draws text. It loads its wasm module and the glyphs with the first job. */

import initWords, { Lettering } from '../pkg-words/inkpanel.js';
import { WORDS_MISSING, loadLetters } from './letters.ts';
import { frontsOf, paintOrder, standsBehind } from './figures.ts';
import { moduleBytes } from './module-bytes.ts';
import { buffersOf } from './protocol.ts';
import { serveJobs } from './serving.ts';
import { createShaping } from './shaping.ts';
import type { Picture } from '../pkg-words/inkpanel.js';
import type { PixelPatch, Wording } from './protocol.ts';
import type { Work } from './serving.ts';
import type { PageDocument, Word } from './types.ts';

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);

type Args<Op extends keyof Wording> = Wording[Op]['args'];

/** After an error, the next job tries again. */
let started: Promise<Work<Wording>> | undefined;

serveJobs<Wording>(async (op, args, slow) => {
  if (!started) slow();
  started ??= start().catch((error) => {
    started = undefined;
    throw error;
  });
  return (await started)[op](args, slow);
});

async function start(): Promise<Work<Wording>> {
  const [bytes, table] = await Promise.all([moduleBytes(MODULE, ...WORDS_MISSING), loadLetters(WORDS_MISSING)]);
  await initWords({ module_or_path: bytes });
  const letters = new Lettering(table);
  const shape = createShaping(letters);
  const shaped = <Of extends { document: string }>(args: Of): Of => {
    shape(JSON.parse(args.document));
    return args;
  };
  return {
    word: (args) => word(letters, shaped(args)),
    words: (args) => words(letters, shaped(args)),
    over: (args) => over(letters, shaped(args)),
  };
}

async function word(letters: Lettering, { index, ...page }: Args<'word'>) {
  const { data, ...place } = pixels(letters, page, index, JSON.parse(page.document));
  const bitmap = await createImageBitmap(new ImageData(data, place.width, place.height));
  return { ok: { ...place, bitmap }, transfer: [bitmap] };
}

async function words(letters: Lettering, page: Args<'words'>) {
  const ok = all(letters, page);
  return { ok, transfer: buffersOf(ok) };
}

async function over(letters: Lettering, { bitmap, ...page }: Args<'over'>) {
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.drawImage(bitmap, 0, 0);
  for (const { data, x, y, ...size } of all(letters, page)) {
    context.drawImage(await createImageBitmap(new ImageData(data, size.width, size.height)), x, y);
  }
  const drawn = canvas.transferToImageBitmap();
  return { ok: drawn, transfer: [drawn] };
}

function all(letters: Lettering, page: Args<'words'>) {
  const document: PageDocument = JSON.parse(page.document);
  return paintOrder(document).map((index) => pixels(letters, page, index, document));
}

/** @param read the document of the page */
function pixels(
  letters: Lettering,
  { document, width: across, fronts }: Args<'words'>,
  index: number,
  read: PageDocument,
) {
  const picture = letters.render(document, index, across);
  if (fronts.length > 0) cut(picture, read, index, fronts);
  const { x, y, width: wide, height } = picture;
  const data = picture.take() as Uint8ClampedArray<ArrayBuffer>;
  picture.free();
  return { x, y, width: wide, height, data };
}

/** Removes the part of a text item that a subject covers. */
function cut(picture: Picture, document: PageDocument, index: number, fronts: PixelPatch[]) {
  const front = fronts[frontsOf(document).indexOf(standsBehind(document.words?.[index] as Word) ?? -1)];
  if (!front) return;
  const { x, y, width, height, data } = front;
  picture.stand_behind(x, y, width, height, new Uint8Array(data.buffer, data.byteOffset, data.length));
}
