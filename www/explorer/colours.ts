/**
 * Main colour and lightness of an image, from its signature. The wall can be filtered by them. Hue and lightness are in
 * Oklab, which is perceptually uniform.
 */

/** In the order of the colour wheel. `mixed` is for several hues, `gray` for pictures without colour. */
export const HUES = ['red', 'orange', 'yellow', 'green', 'cyan', 'blue', 'purple', 'pink', 'mixed', 'gray'] as const;
export type Hue = (typeof HUES)[number];
export const LIGHTNESSES = ['dark', 'middle', 'light'] as const;
export type Lightness = (typeof LIGHTNESSES)[number];

/** End of each hue on the colour wheel, in degrees of Oklab. Pink continues past 360 to the start of red. */
const ENDS: readonly [Hue, number][] = [
  ['pink', 10],
  ['red', 42],
  ['orange', 82],
  ['yellow', 118],
  ['green', 170],
  ['cyan', 225],
  ['blue', 285],
  ['purple', 325],
  ['pink', 360],
];
/** Mean chroma below which a picture is gray. */
const GRAY = 0.022;
/** Share of the colour that one hue has, unless several are mixed. */
const MAIN = 0.42;
/** Maximum mean lightness of a dark picture, and minimum of a light one. */
const [DARK, LIGHT] = [0.45, 0.72];
/** Bytes of a cell: red, green, blue and roughness. */
const CELL = 4;

/** @param signature of an image, from the core: 4 bytes per cell */
export function coloursOf(signature: Uint8Array): { hue: Hue; lightness: Lightness } {
  const weights = new Map<Hue, number>();
  let [light, chroma, cells] = [0, 0, 0];
  for (let i = 0; i + CELL <= signature.length; i += CELL) {
    const [l, a, b] = oklab(signature[i], signature[i + 1], signature[i + 2]);
    const colour = Math.hypot(a, b);
    const degrees = (Math.atan2(b, a) * (180 / Math.PI) + 360) % 360;
    const hue = ENDS.find(([, end]) => degrees < end)?.[0] ?? 'pink';
    weights.set(hue, (weights.get(hue) ?? 0) + colour);
    light += l;
    chroma += colour;
    cells += 1;
  }
  const [main, most] = [...weights].reduce((best, one) => (one[1] > best[1] ? one : best), ['gray' as Hue, 0] as const);
  const mean = light / Math.max(1, cells);
  return {
    hue: chroma / Math.max(1, cells) < GRAY ? 'gray' : most < MAIN * chroma ? 'mixed' : main,
    lightness: mean < DARK ? 'dark' : mean < LIGHT ? 'middle' : 'light',
  };
}

/** Converts sRGB bytes to Oklab, after Ottosson. */
function oklab(red: number, green: number, blue: number): [number, number, number] {
  const [r, g, b] = [red, green, blue].map((byte) => {
    const value = byte / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}
