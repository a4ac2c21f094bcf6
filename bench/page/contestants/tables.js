// @ts-check
/** The tables and matrices that make the peers do the same as Inkpanel's blocks. */

/** @param {(value: number) => number} f */
const table = (f) => Uint8ClampedArray.from({ length: 256 }, (_, value) => f(value));

/** @param {number} levels */
export const posterize = (levels) => table((v) => (Math.floor((v * levels) / 256) * 255) / (levels - 1));

/** @param {number} phi @param {number} epsilon */
export const softThreshold = (phi, epsilon) => table((v) => 255 * (1 + Math.tanh(Math.min(0, phi * (v - epsilon)))));

const LUMA = [0.299, 0.587, 0.114];

/** Rows of the matrix Y + amount (rgb - Y). @param {number} amount */
export const saturation = (amount) =>
  [0, 1, 2].flatMap((row) => LUMA.map((l, column) => (1 - amount) * l + (row === column ? amount : 0)));

/** Rows of the matrix that turns U and V. @param {number} degrees */
export function hue(degrees) {
  const [cos, sin] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  // U and V of each primary colour, and their contributions to red, green and blue (BT.601, full range).
  const u = [-0.168736, -0.331264, 0.5];
  const v = [0.5, -0.418688, -0.081312];
  const back = [
    [0, 1.402],
    [-0.344136, -0.714136],
    [1.772, 0],
  ];
  return back.flatMap(([fromU, fromV]) =>
    LUMA.map((l, i) => l + fromU * (cos * u[i] - sin * v[i]) + fromV * (sin * u[i] + cos * v[i])),
  );
}

/**
 * The values below which `low` and `high` percent of the samples lie, at least 1 apart.
 * @param {ArrayLike<number>} histogram 256 counts
 * @param {number} low
 * @param {number} high
 */
export function percentiles(histogram, low, high) {
  const counts = Array.from(histogram);
  const total = counts.reduce((a, b) => a + b, 0);
  const at = (/** @type {number} */ percent) => {
    let sum = 0;
    return counts.findIndex((count) => (sum += count) >= (total * percent) / 100);
  };
  const from = at(low);
  return [from, Math.max(from + 1, at(high))];
}
