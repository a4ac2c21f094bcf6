// @ts-check
/**
 * The detectors' worker: their wasm module and nets, loaded with the first job.
 */

import initDetector, { Detector } from '../pkg-detector/inkpanel.js';
import { describe, failure } from './protocol.js';

const MODULE = new URL('../pkg-detector/inkpanel_bg.wasm', import.meta.url);
const FACES = new URL('../models/faces.onnx', import.meta.url);
const OBJECTS = new URL('../models/objects.onnx', import.meta.url);

/** @typedef {import('./protocol.js').PhotoHandle} PhotoHandle */
/** @typedef {import('./detector.js').Found} Found */

/** @type {Promise<Detector> | undefined} */
let started;

/** @param {MessageEvent<{ id: number, op: 'look' | 'lookCloser', args: { photo: PhotoHandle, boxes?: Found[] } }>} event */
globalThis.onmessage = async ({ data: { id, op, args: { photo, boxes } } }) => {
  try {
    started ??= start();
    const detector = await started;
    const { width, height } = photo;
    const planes = new Uint8Array(await photo.planes.arrayBuffer());
    const ok = op === 'look'
      ? look(detector, width, height, planes)
      : JSON.parse(detector.look_closer(width, height, planes, JSON.stringify(boxes)));
    postMessage({ id, ok, memory: 0 });
  } catch (error) {
    postMessage({ id, error: describe(error), memory: 0 });
  }
};

/**
 * @param {Detector} detector
 * @param {number} width
 * @param {number} height
 * @param {Uint8Array} planes
 * @returns {{ boxes: Found[], closer: boolean }} faces first
 */
function look(detector, width, height, planes) {
  const { boxes, closer } = JSON.parse(detector.faces(width, height, planes));
  return { boxes: [...boxes, ...JSON.parse(detector.objects(width, height, planes))], closer };
}

async function start() {
  const [module, faces, objects] = await Promise.all([MODULE, FACES, OBJECTS].map(load));
  await initDetector({ module_or_path: module });
  return new Detector(new Uint8Array(faces), new Uint8Array(objects));
}

/** @param {URL} address */
async function load(address) {
  const response = await fetch(address).catch(() => null);
  const text = response?.headers.get('content-type')?.startsWith('text/html');
  // A host may answer with a page of its own where a file is missing.
  if (!response?.ok || text) throw failure('detector-missing', 'The detectors could not be loaded.');
  return response.arrayBuffer();
}
