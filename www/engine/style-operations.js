// @ts-check
/** What a worker does with styles in the making: draws a design step by step, and tries out many at once. */

import { FOREGROUND } from './design.js';

/** @typedef {import('./protocol.js').Operations} Operations */
/** @typedef {import('./operations.js').Answer} Answer */

/**
 * @param {{
 *   studio: import('../pkg/inkpanel.js').Studio, fetchPhotos: (photos: import('./protocol.js').PhotoHandle[]) => Promise<void>,
 *   bitmap: (patch: import('../pkg/inkpanel.js').Patch) => Promise<{ ok: import('./protocol.js').BitmapPatch, transfer: Transferable[] }>,
 * }} worker
 */
export function createStyleOperations({ studio, fetchPhotos, bitmap }) {
  /** How long each block took when it ran last, by photo and size. @type {Map<string, Map<number, number>>} */
  const clocks = new Map();

  return { design, explore };

  /**
   * @param {Operations['design']['args']} args
   * @returns {Promise<Answer>}
   */
  async function design({ photo, style, width, height, stages }) {
    await fetchPhotos([photo]);
    studio.design(photo.key, style, width, height);
    const { background, foreground = [] } = JSON.parse(style);
    const places = [...background.map((/** @type {any} */ _, /** @type {number} */ i) => i), ...foreground.map((/** @type {any} */ _, /** @type {number} */ i) => FOREGROUND + i)];
    const times = timed(`${photo.key} ${width} ${height}`);
    const whole = await bitmap(studio.design_result());
    const pictures = await Promise.all((stages > 0 ? places : []).map(async (place) => {
      const { ok } = await bitmap(studio.design_stage(place, stages));
      return { place, bitmap: ok.bitmap };
    }));
    const ok = { ...whole.ok, times: places.map((place) => [place, times.get(place) ?? 0]), stages: pictures };
    return { ok, transfer: [...whole.transfer, ...pictures.map((picture) => picture.bitmap)] };
  }

  /** Runs what is left of the design, block by block. @param {string} name @returns {Map<number, number>} */
  function timed(name) {
    const times = clocks.get(name) ?? new Map();
    // A handful of photos is looked at; the clocks of all others would only pile up.
    if (!clocks.has(name) && clocks.size > 16) clocks.clear();
    clocks.set(name, times);
    for (;;) {
      const start = performance.now();
      const place = studio.design_step();
      if (place < 0) return times;
      times.set(place, performance.now() - start);
    }
  }

  /**
   * A photo in some styles, each with its score, look and signature; a style that fails is left out.
   * @param {Operations['explore']['args']} args
   * @returns {Promise<Answer>}
   */
  async function explore({ photo, styles, width, height }) {
    await fetchPhotos([photo]);
    const ok = await Promise.all(styles.map(async (style, index) => {
      const found = studio.explore(photo.key, style, width, height);
      const { score, novelty, fault, look, signature } = found;
      const patch = found.patch();
      found.free();
      return { index, score, novelty, fault, look, signature, bitmap: (await bitmap(patch)).ok.bitmap };
    }));
    return { ok, transfer: ok.map((item) => item.bitmap) };
  }
}
