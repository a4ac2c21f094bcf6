// @ts-check
/** Measures the model that rates pictures, for one picture on this thread. */

import init, { AestheticsNet } from '/detector/inkpanel.js';

const PHOTOS = ['/album/09-mariachi.jpg', '/album/02-kitten.jpg', '/album/13-didgeridoo.jpg'];
/** A thumbnail of the explorer. */
const [WIDTH, HEIGHT] = [240, 180];
const RUNS = 9;

/**
 * @returns {Promise<{ ms: number, load: number } | null>} the median, and `load` with compilation, measured once; null
 * if the model is missing
 */
export async function aesthetics() {
  const file = await fetch('/models/aesthetics.onnx');
  if (!file.ok) return null;
  const onnx = new Uint8Array(await file.arrayBuffer());
  const before = performance.now();
  await init();
  const net = new AestheticsNet(onnx);
  const load = performance.now() - before;
  const pictures = await Promise.all(PHOTOS.map(pixelsOf));
  const times = [];
  for (let run = 0; run < RUNS; run += 1) {
    for (const picture of pictures) {
      const start = performance.now();
      net.score(WIDTH, HEIGHT, picture);
      times.push(performance.now() - start);
    }
  }
  return { ms: times.sort((a, b) => a - b)[times.length >> 1], load };
}

/** @param {string} address */
async function pixelsOf(address) {
  const bitmap = await createImageBitmap(await (await fetch(address)).blob());
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
    new OffscreenCanvas(WIDTH, HEIGHT).getContext('2d')
  );
  context.drawImage(bitmap, 0, 0, WIDTH, HEIGHT);
  return new Uint8Array(context.getImageData(0, 0, WIDTH, HEIGHT).data.buffer);
}
