// @ts-check
/** Measures the time of a plan with analysed photos, and the time of the analysis of a photo. */

import init, { Album, benchFacts } from '/pkg/inkpanel.js';

const PLANS = 31;
const PAGE = { width: 2480, height: 3508 };
const KEEP = { layout: false, style: false, photos: false };

/** @returns {Promise<{ count: number, ms: number, first: number }[]>} medians; `first`: of a photo that is new */
export async function plans() {
  await init();
  return [100, 1000].map(measured);
}

/**
 * Milliseconds of the analysis of a photo for framing.
 * @param {import('./contest.js').Picture} picture at any size
 */
export async function factsOf({ width, height, data }) {
  await init();
  return Math.min(
    ...Array.from({ length: PLANS }, () => {
      const start = performance.now();
      benchFacts(width, height, data);
      return performance.now() - start;
    }),
  );
}

/** @param {number} count of photos */
function measured(count) {
  const album = new Album();
  const photos = Array.from({ length: count }, (_, i) => photo(i));
  album.know(JSON.stringify(photos));
  const ids = JSON.stringify(photos.map(({ id }) => id));
  const plan = (/** @type {number} */ seed) => {
    const start = performance.now();
    album.plan(JSON.stringify({ seed, photos: [], page: PAGE, current: null, keep: KEEP, mode: 'shuffle' }), ids);
    return performance.now() - start;
  };
  const first = plan(0);
  const times = Array.from({ length: PLANS }, (_, i) => plan(i + 1)).sort((a, b) => a - b);
  const ms = times[PLANS >> 1];
  album.free();
  return { count, ms, first: (first - ms) / count };
}

/**
 * A photo with something to see in a corner of it, and a face in every third.
 * @param {number} i
 */
function photo(i) {
  const [columns, rows] = [24, 16];
  const values = Array.from({ length: columns * rows }, (_, cell) => {
    const [x, y] = [cell % columns, Math.floor(cell / columns)];
    const far = Math.hypot(x - (i % columns), y - (i % rows));
    return Math.max(0, 255 - Math.round(far * 24))
      .toString(16)
      .padStart(2, '0');
  });
  const face = { label: 'face', score: 0.9, x: 0.3, y: 0.1 + (i % 5) / 10, width: 0.15, height: 0.2 };
  return {
    id: `p${i}`,
    width: i % 4 === 3 ? 3000 : 4000,
    height: i % 4 === 3 ? 4000 : 3000,
    fingerprint: ((BigInt(i + 1) * 0x9e3779b97f4a7c15n) & 0xffffffffffffffffn).toString(16).padStart(16, '0'),
    sharpness: 100 + (i % 7),
    taken: null,
    energy: { columns, rows, values: values.join('') },
    subjects: i % 3 === 0 ? [face] : [],
    focus: null,
  };
}
