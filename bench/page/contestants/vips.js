// @ts-check
/** libvips in wasm, with its threads. Its images are lazy: `copyMemory` makes the pixels. */

import Vips from '/modules/wasm-vips/lib/vips-es6.js';
import * as tables from './tables.js';

/** @type {import('../contest.js').Load} */
export async function load({ width, height, data }) {
  const vips = await Vips({ dynamicLibraries: [] });
  vips.Cache.max(0);
  const rgb = vips.Image.newFromMemory(
    data.filter((_, i) => i % 4 !== 3),
    width,
    height,
    3,
    'uchar',
  ).copyMemory();
  const gray = rgb.colourspace('b-w').copyMemory();
  const table = (/** @type {Uint8ClampedArray} */ t) => vips.Image.newFromMemory(t, 256, 1, 1, 'uchar').copyMemory();
  const done = (/** @type {any[]} */ ...images) => {
    images[0].copyMemory().delete();
    for (const image of images) image.delete();
  };

  return ({ id, luma, params: p }) => {
    const source = luma ? gray : rgb;
    switch (id.split(' ')[0]) {
      case 'to_gray':
        return () => done(rgb.colourspace('b-w'));
      case 'posterize':
      case 'luma_posterize': {
        const lut = table(tables.posterize(p.levels));
        return () => done(source.maplut(lut));
      }
      case 'soft_threshold': {
        const lut = table(tables.softThreshold(p.phi, p.epsilon));
        return () => done(gray.maplut(lut));
      }
      case 'brightness':
        return () => done(source.linear(p.gain, 0, { uchar: true }));
      case 'saturation':
      case 'hue': {
        const m = id.startsWith('hue') ? tables.hue(p.angle) : tables.saturation(p.amount);
        const matrix = vips.Image.newFromArray([m.slice(0, 3), m.slice(3, 6), m.slice(6)]);
        return () => {
          const mixed = rgb.recomb(matrix);
          done(mixed.cast('uchar'), mixed);
        };
      }
      case 'gaussian':
        return () => done(source.gaussblur(p.sigma));
      case 'sobel':
        return () => done(gray.sobel());
      case 'xdog':
        return () => {
          const [a, b] = [gray.gaussblur(p.sigma), gray.gaussblur(1.6 * p.sigma)];
          const [sharp, wide] = [a.linear(1 + p.p, 0), b.linear(p.p, 0)];
          const difference = sharp.subtract(wide);
          done(difference.cast('uchar'), difference, sharp, wide, a, b);
        };
      case 'size':
        return () => done(source.resize(p.percent / 100, { kernel: p.percent < 100 ? 'linear' : 'cubic' }));
      case 'equalize':
        return () => {
          const [from, to] = [gray.percent(p.low), gray.percent(p.high)];
          done(gray.linear(255 / (to - from), (-255 * from) / (to - from), { uchar: true }));
        };
      default:
        return undefined;
    }
  };
}
