// @ts-check
/**
 * The worker of a detector, of the one for faces or of the one for objects: the module that both have, and one net,
 * loaded with the first job.
 */

import { FaceDetector, ObjectDetector } from '../pkg-detector/inkpanel.js';
import { net } from './detector-module.js';
import { describe } from './protocol.js';

const faceNet = net(new URL('../models/faces.onnx', import.meta.url), (onnx) => new FaceDetector(onnx));
const objectNet = net(new URL('../models/objects.onnx', import.meta.url), (onnx) => new ObjectDetector(onnx));

/** @typedef {import('./protocol.js').PhotoHandle} PhotoHandle */
/** @typedef {import('./detector.js').Found} Found */
/** @typedef {'faces' | 'closer' | 'objects'} Op */

/** @param {MessageEvent<{ id: number, op: Op, args: { photo: PhotoHandle, boxes?: Found[] } }>} event */
globalThis.onmessage = async ({ data: { id, op, args: { photo, boxes } } }) => {
  try {
    const [run, pixels] = await Promise.all([runner(op, boxes), photo.planes.arrayBuffer()]);
    postMessage({ id, ok: JSON.parse(run(photo.width, photo.height, new Uint8Array(pixels))), memory: 0 });
  } catch (error) {
    postMessage({ id, error: describe(error), memory: 0 });
  }
};

/**
 * @param {Op} op
 * @param {Found[]} [boxes] of the first look
 * @returns {Promise<(width: number, height: number, planes: Uint8Array) => string>}
 */
async function runner(op, boxes) {
  if (op === 'objects') {
    const objects = await objectNet();
    return (...photo) => objects.look(...photo);
  }
  const faces = await faceNet();
  return (...photo) => (op === 'faces' ? faces.look(...photo) : faces.look_closer(...photo, JSON.stringify(boxes)));
}
