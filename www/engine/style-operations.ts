/** Worker operations for new styles: draws a design step by step, and tries many styles. */

import { FOREGROUND } from './design.ts';
import { imitating } from './imitation-module.ts';
import { mentionsPainter, paintersFile } from './painters.ts';
import { NOT_CLIPPED } from './protocol.ts';
import type { Sitter } from '../pkg-imitation/inkpanel.js';
import type { Patch, Studio } from '../pkg/inkpanel.js';
import type { Designed } from './design.ts';
import type { BitmapPatch, Clipped, Explored, Operations, PhotoHandle } from './protocol.ts';
import type { Answer } from './serving.ts';
import type { Style } from './types.ts';

/** Minimum channel value of pure white, and maximum channel value of pure black. */
const [PURE_WHITE, PURE_BLACK] = [251, 4];
/** Grey steps from the lightest or darkest tone of an image, and the part of the pixels that may be beyond that tone. */
const [NEAR_END, FEW] = [10, 0.005];

export function createStyleOperations({
  studio,
  fetchPhotos,
  bitmap,
}: {
  studio: Studio;
  fetchPhotos: (photos: PhotoHandle[]) => Promise<void>;
  bitmap: (
    patch: Patch,
    measure?: (data: Uint8ClampedArray) => void,
  ) => Promise<{ ok: BitmapPatch; transfer: Transferable[] }>;
}) {
  /** Duration of each block in its last run, by photo and size. */
  const clocks: Map<string, Map<number, number>> = new Map();
  let sitting: { key: string; sitter: Sitter } | null = null;

  return { design, explore, readLook, tryLooks };

  async function design({
    photo,
    style,
    width,
    height,
    stages,
  }: Operations['design']['args']): Promise<Answer<Designed>> {
    await fetchPhotos([photo]);
    studio.design(photo.key, style, width, height);
    const { background, foreground = [] }: Style = JSON.parse(style);
    const places = [...background.map((_, i) => i), ...foreground.map((_, i) => FOREGROUND + i)];
    const times = timed(`${photo.key} ${width} ${height}`);
    const whole = await bitmap(studio.design_result());
    const pictures = await Promise.all(
      (stages > 0 ? places : []).map(async (place) => {
        const { ok } = await bitmap(studio.design_stage(place, stages));
        return { place, bitmap: ok.bitmap };
      }),
    );
    const spent = places.map((place): [number, number] => [place, times.get(place) ?? 0]);
    const ok = { ...whole.ok, times: spent, stages: pictures };
    return { ok, transfer: [...whole.transfer, ...pictures.map((picture) => picture.bitmap)] };
  }

  /** Runs the remaining blocks of the design. */
  function timed(name: string): Map<number, number> {
    const times = clocks.get(name) ?? new Map();
    // Only a few photos are active, so the clocks of others are removed.
    if (!clocks.has(name) && clocks.size > 16) clocks.clear();
    clocks.set(name, times);
    for (;;) {
      const start = performance.now();
      const place = studio.design_step();
      if (place < 0) return times;
      times.set(place, performance.now() - start);
    }
  }

  /** The look of a picture, as text that only the search reads. */
  async function readLook({ photo, anyway }: Operations['readLook']['args']): Promise<Answer<string>> {
    const { picture_look } = await imitating();
    await fetchPhotos([photo]);
    const { key, width, height } = photo;
    return { ok: picture_look(width, height, studio.photo_planes(key), anyway), transfer: [] };
  }

  /** The photo for style trials; one at a time. */
  async function sitterOf(photo: PhotoHandle): Promise<Sitter> {
    const { key, width, height } = photo;
    if (sitting?.key !== key) {
      const { Sitter } = await imitating();
      await fetchPhotos([photo]);
      sitting?.sitter.free();
      sitting = null;
      sitting = { key, sitter: new Sitter(width, height, studio.photo_planes(key)) };
    }
    return sitting.sitter;
  }

  /** Looks of a photo in some styles. Styles that cannot be drawn are skipped. */
  async function tryLooks({ photo, asks }: Operations['tryLooks']['args']): Promise<Answer<(string | null)[]>> {
    const sitter = await sitterOf(photo);
    // The worker loaded the file before this job.
    if (mentionsPainter(asks)) sitter.know_painters(await paintersFile());
    const ok = asks.map((ask) => {
      try {
        return sitter.try_look(JSON.stringify(ask));
      } catch (error) {
        // A trap terminates this worker; errors of the core have a code.
        if ((error as { code?: string }).code === undefined) throw error;
        return null;
      }
    });
    return { ok, transfer: [] };
  }

  /** A photo in some styles, each with its score, look and signature. Styles with errors are skipped. */
  async function explore({ photo, styles, width, height }: Operations['explore']['args']): Promise<Answer<Explored[]>> {
    await fetchPhotos([photo]);
    const ok = await Promise.all(
      styles.map(async (style, index) => {
        const found = studio.explore(photo.key, style, width, height);
        const { score, novelty, fault, look, signature } = found;
        const patch = found.patch();
        found.free();
        let clipped = NOT_CLIPPED;
        const { ok } = await bitmap(patch, (data) => {
          clipped = clippedParts(data);
        });
        return { index, score, novelty, fault, look, signature, clipped, bitmap: ok.bitmap };
      }),
    );
    return { ok, transfer: ok.map((item) => item.bitmap) };
  }
}

/** The parts of the pixels of an image with extreme tones, up to a few steps. */
export function clippedParts(data: ArrayLike<number>): Clipped {
  let [white, black] = [0, 0];
  const tones = new Uint32Array(256);
  for (let at = 0; at < data.length; at += 4) {
    const [r, g, b] = [data[at], data[at + 1], data[at + 2]];
    white += Number(Math.min(r, g, b) >= PURE_WHITE);
    black += Number(Math.max(r, g, b) <= PURE_BLACK);
    tones[Math.round(0.299 * r + 0.587 * g + 0.114 * b)] += 1;
  }
  const pixels = Math.max(1, data.length / 4);
  const [darkest, lightest] = [endOf(tones, pixels), endOf(tones.slice().reverse(), pixels)];
  return { white: white / pixels, black: black / pixels, lightest, darkest };
}

/** The part of the pixels whose tone is near the first tone of an image. A few pixels do not count as its first tone. */
function endOf(tones: Uint32Array, pixels: number): number {
  let [first, sum] = [0, tones[0]];
  while (sum < FEW * pixels) sum += tones[(first += 1)];
  return tones.subarray(0, first + NEAR_END + 1).reduce((all, count) => all + count, 0) / pixels;
}
