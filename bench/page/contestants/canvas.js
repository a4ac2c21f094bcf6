// @ts-check
/**
 * The canvas 2D context's own filters. Canvases record drawing commands and run them when pixels are read, so each run
 * reads one pixel.
 */

import * as tables from './tables.js';

/** @type {import('../contest.js').Load} */
export async function load({ width, height, data }) {
  const bitmap = await createImageBitmap(new ImageData(new Uint8ClampedArray(data), width, height));
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d', { willReadFrequently: true }));
  const draw =
    (/** @type {string} */ filter, w = width, h = height) =>
    () => {
      context.filter = filter;
      context.drawImage(bitmap, 0, 0, w, h);
      context.getImageData(0, 0, 1, 1);
    };

  return ({ id, luma, params: p }) => {
    // A canvas has no plane of luma; it is compared where colour is filtered.
    if (luma) return undefined;
    switch (id.split(' ')[0]) {
      case 'to_gray':
        return draw('grayscale(1)');
      case 'brightness':
        return draw(`brightness(${p.gain})`);
      case 'saturation':
        return draw(`saturate(${p.amount})`);
      case 'hue':
        return draw(`hue-rotate(${p.angle}deg)`);
      case 'gaussian':
        return draw(`blur(${p.sigma}px)`);
      case 'posterize':
        posterize(p.levels);
        return draw('url(#posterize)');
      case 'size':
        context.canvas.width = (width * p.percent) / 100;
        context.canvas.height = (height * p.percent) / 100;
        context.imageSmoothingQuality = 'high';
        return draw('none', context.canvas.width, context.canvas.height);
      default:
        return undefined;
    }
  };
}

/** Sets the page's SVG filter. @param {number} levels */
function posterize(levels) {
  const steps = tables.posterize(levels);
  const values = Array.from({ length: levels }, (_, i) => steps[Math.ceil((i * 256) / levels)] / 255).join(' ');
  const transfer = /** @type {Element} */ (document.querySelector('feComponentTransfer'));
  transfer.innerHTML = ['R', 'G', 'B']
    .map((channel) => `<feFunc${channel} type="discrete" tableValues="${values}"/>`)
    .join('');
}
