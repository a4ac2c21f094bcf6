// @ts-check
/**
 * The worker of a detector, of the one for faces or of the one for objects: the module that both have, and one net,
 * loaded with the first job.
 */

import { net } from './detector-module.js';
import { LOOKS } from './measured.js';
import { LOADING, serveJobs } from './serving.js';

const faces = net(new URL('../models/faces.onnx', import.meta.url), ({ FaceDetector }, onnx) => new FaceDetector(onnx));
const objects = net(new URL('../models/objects.onnx', import.meta.url), ({ ObjectDetector }, onnx) => new ObjectDetector(onnx));

/** @typedef {import('./protocol.js').PhotoHandle} PhotoHandle */
/** @typedef {import('./detector.js').Found} Found */
/** @typedef {'faces' | 'closer' | 'objects'} Look */
/** @typedef {{ op: 'load' | 'make', args: { net: 'faces' | 'objects' } } | { op: Look, args: { photo: PhotoHandle, boxes?: Found[] } }} Order */

serveJobs(async (op, args, tell) => ({ ok: await obey(/** @type {Order} */ ({ op, args }), tell) }));

/** @param {Order} order @param {import('./serving.js').Tell} tell */
async function obey({ op, args }, tell) {
  tell.waits(LOADING);
  if ('net' in args) {
    const { load, ready } = args.net === 'faces' ? faces : objects;
    await (op === 'load' ? load() : ready());
    return null;
  }
  const { photo, boxes } = args;
  const look = /** @type {Look} */ (op);
  const [run, pixels] = await Promise.all([runner(look, boxes), photo.planes.arrayBuffer()]);
  tell.expects(LOOKS[look]);
  return JSON.parse(run(photo.width, photo.height, new Uint8Array(pixels)));
}

/**
 * @param {Look} look
 * @param {Found[]} [boxes] of the first look
 * @returns {Promise<(width: number, height: number, planes: Uint8Array) => string>}
 */
async function runner(look, boxes) {
  if (look === 'objects') {
    const net = await objects.ready();
    return (...photo) => net.look(...photo);
  }
  const net = await faces.ready();
  return (...photo) => (look === 'faces' ? net.look(...photo) : net.look_closer(...photo, JSON.stringify(boxes)));
}
