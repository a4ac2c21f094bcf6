/** Warm-up of the wasm code with synthetic photos; see `warming.ts`. */

import type { Studio } from '../pkg/inkpanel.js';
import type { Operations } from './protocol.ts';

/** A size that is decoded completely, and one that is decoded at reduced size (`decode_reduced` in Rust). */
const SIZES = [
  [1500, 1000],
  [3200, 480],
];
/** The width of the page, in pixels. */
const PAGE = 480;
/** Maximum number of random bytes per call in browsers. */
const AT_ONCE = 65_536;

export function createWarmUp(studio: Studio) {
  const photos: Promise<Uint8Array>[] = [];
  let round = 0;

  return async ({ document }: Operations['warm']['args']): Promise<{ ok: null }> => {
    const which = round % SIZES.length;
    round += 1;
    const bytes = await (photos[which] ??= grainy(SIZES[which]));
    studio.import_photo('warm', bytes);
    try {
      studio.compose(document, PAGE, 'work').free();
    } finally {
      for (const size of ['work', 'small']) studio.drop_photo(`warm/${size}`);
    }
    return { ok: null };
  };
}

/** A file with edges and grain, like camera files. Smooth colours would skip most of the decoder. */
async function grainy([width, height]: number[]): Promise<Uint8Array> {
  const { data } = new ImageData(width, height);
  for (let at = 0; at < data.length; at += AT_ONCE) crypto.getRandomValues(data.subarray(at, at + AT_ONCE));
  for (let at = 0; at < data.length; at += 4) {
    const [x, y] = [(at / 4) % width, Math.floor(at / 4 / width)];
    const light = ((x >> 6) ^ (y >> 6)) % 7;
    for (let channel = 0; channel < 3; channel += 1)
      data[at + channel] = 24 * light + 8 * channel + data[at + channel] / 8;
    data[at + 3] = 255;
  }
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext('2d')?.putImageData(new ImageData(data, width, height), 0, 0);
  const file = await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.92 });
  return new Uint8Array(await file.arrayBuffer());
}
