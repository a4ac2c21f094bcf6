/**
 * The worker that draws words: their wasm module and the letters, loaded with the first job.
 */

import initWords, { Lettering } from '../pkg-words/inkpanel.js';
import { WORDS_MISSING, loadLetters } from './letters.ts';
import { wordMs } from './measured.ts';
import { moduleBytes } from './module-bytes.ts';
import { LOADING, serveJobs } from './serving.ts';
import { createShaping } from './shaping.ts';
import type { Wording } from './protocol.ts';
import type { Tell, Work } from './serving.ts';
import type { PageDocument } from './types.ts';

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);

type Args<Op extends keyof Wording> = Wording[Op]['args'];

/** The next job tries again where it failed. */
let started: Promise<Work<Wording>> | undefined;

serveJobs<Wording>(async (op, args, tell) => {
  tell.waits(LOADING);
  started ??= start().catch((error) => {
    started = undefined;
    throw error;
  });
  return (await started)[op](args, tell);
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
    word: (args, tell) => word(letters, shaped(args), tell),
    words: (args, tell) => words(letters, shaped(args), tell),
    over: (args, tell) => over(letters, shaped(args), tell),
  };
}

async function word(letters: Lettering, { document, index, width }: Args<'word'>, tell: Tell) {
  tell.expects(wordMs(width * width));
  const { data, ...place } = pixels(letters, document, index, width);
  const bitmap = await createImageBitmap(new ImageData(data, place.width, place.height));
  return { ok: { ...place, bitmap }, transfer: [bitmap] };
}

async function words(letters: Lettering, { document, width }: Args<'words'>, tell: Tell) {
  const ok = all(letters, document, width, tell);
  return { ok, transfer: ok.map(({ data }) => data.buffer) };
}

async function over(letters: Lettering, { document, width, bitmap }: Args<'over'>, tell: Tell) {
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.drawImage(bitmap, 0, 0);
  for (const { data, x, y, ...size } of all(letters, document, width, tell)) {
    context.drawImage(await createImageBitmap(new ImageData(data, size.width, size.height)), x, y);
  }
  const drawn = canvas.transferToImageBitmap();
  return { ok: drawn, transfer: [drawn] };
}

function all(letters: Lettering, document: string, width: number, tell: Tell) {
  const { words = [] }: PageDocument = JSON.parse(document);
  return words.map((_, index) => {
    tell.expects(wordMs(width * width));
    return pixels(letters, document, index, width);
  });
}

function pixels(letters: Lettering, document: string, index: number, width: number) {
  const picture = letters.render(document, index, width);
  const { x, y, width: wide, height } = picture;
  const data = picture.take() as Uint8ClampedArray<ArrayBuffer>;
  picture.free();
  return { x, y, width: wide, height, data };
}
