// @ts-check
/** How long the detectors take for a photo, on this thread. */

import init, { FaceDetector, ObjectDetector, SubjectNet } from '/detector/inkpanel.js';

const PHOTOS = ['/album/09-mariachi.jpg', '/album/02-kitten.jpg', '/album/13-didgeridoo.jpg'];
/** Longest side of the images that the app passes to detection. */
const SIDE = 1024;
const RUNS = 7;

/** @returns {Promise<{ faces: number, objects: number, load: number, subject: number }>} medians in milliseconds; `load` with compiling, once */
export async function detect() {
  const bytes = async (/** @type {string} */ path) => new Uint8Array(await (await fetch(path)).arrayBuffer());
  const nets = await Promise.all(['/models/faces.onnx', '/models/objects.onnx'].map(bytes));
  const before = performance.now();
  await init();
  const [faces, objects] = [new FaceDetector(nets[0]), new ObjectDetector(nets[1])];
  const load = performance.now() - before;
  const subjects = new SubjectNet(await bytes('/models/subject.onnx'));
  const photos = await Promise.all(PHOTOS.map(planesOf));
  const time = (/** @type {(width: number, height: number, planes: Uint8Array) => unknown} */ look) => {
    const times = [];
    for (let run = 0; run < RUNS; run += 1) {
      for (const { width, height, planes } of photos) {
        const start = performance.now();
        look(width, height, planes);
        times.push(performance.now() - start);
      }
    }
    return times.sort((a, b) => a - b)[times.length >> 1];
  };
  return {
    faces: time((...photo) => faces.look(...photo)),
    objects: time((...photo) => objects.look(...photo)),
    load,
    subject: time((...photo) => subjectOf(subjects, ...photo)),
  };
}

/**
 * The subject of a photo, by all steps at once.
 * @param {SubjectNet} net
 * @param {number} width
 * @param {number} height
 * @param {Uint8Array} planes
 * @returns {string}
 */
export function subjectOf(net, width, height, planes) {
  const look = net.begin(width, height, planes);
  try {
    for (;;) {
      const mask = look.advance();
      if (mask !== undefined) return mask;
    }
  } finally {
    look.free();
  }
}

/** @param {string} address */
async function planesOf(address) {
  const bitmap = await createImageBitmap(await (await fetch(address)).blob());
  const scale = Math.min(1, SIDE / Math.max(bitmap.width, bitmap.height));
  const [width, height] = [Math.round(bitmap.width * scale), Math.round(bitmap.height * scale)];
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
    new OffscreenCanvas(width, height).getContext('2d')
  );
  context.drawImage(bitmap, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  const planes = new Uint8Array(width * height * 3);
  for (let i = 0; i < width * height; i += 1)
    for (let c = 0; c < 3; c += 1) planes[c * width * height + i] = data[i * 4 + c];
  return { width, height, planes };
}
