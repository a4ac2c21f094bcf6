/**
 * The worker of a detector, for faces or for objects. It loads the shared module and one model with the first job. The
 * worker for faces loads the landmark model with the first large face.
 */

import { detach } from './blobs.ts';
import { module, net } from './detector-module.ts';
import { NET as LANDMARKS } from './landmarks-net.ts';
import { serveJobs } from './serving.ts';
import type { Detection } from './types.ts';
import type { Looking, PhotoHandle } from './protocol.ts';
import type { Slow, Work } from './serving.ts';

const faces = net(new URL('../models/faces.onnx', import.meta.url), ({ FaceDetector }, onnx) => new FaceDetector(onnx));
const objects = net(
  new URL('../models/objects.onnx', import.meta.url),
  ({ ObjectDetector }, onnx) => new ObjectDetector(onnx),
);

/** Optional, and not loaded before the first large face. */
const reader = LANDMARKS === undefined ? undefined : net(LANDMARKS, ({ FaceReader }, onnx) => new FaceReader(onnx));

export type Look = 'faces' | 'closer' | 'objects' | 'lips';

const OPERATIONS: Work<Looking> = {
  load: async (args) => ({
    ok: await named(args)
      .load()
      .then(() => null),
  }),
  make: async (args) => ({
    ok: await named(args)
      .ready()
      .then(() => null),
  }),
  faces: async (args, slow) => ({ ok: await looked('faces', args, slow) }),
  closer: async (args, slow) => ({ ok: await looked('closer', args, slow) }),
  objects: async (args, slow) => ({ ok: await looked('objects', args, slow) }),
  lips: async ({ photo, boxes = [] }, slow) => ({
    ok: await withExpressions(boxes, photo, new Uint8Array(await photo.planes.arrayBuffer()), slow),
  }),
};

serveJobs<Looking>((op, args, slow) => OPERATIONS[op](args, slow));

function named({ net }: Looking['load']['args']) {
  return net === 'faces' ? faces : objects;
}

async function looked<Op extends Exclude<Look, 'lips'>>(
  look: Op,
  { photo, boxes, objects: known }: Looking[Op]['args'],
  slow: Slow,
): Promise<Looking[Op]['ok']> {
  const [run, pixels] = await Promise.all([runner(look, boxes, known), photo.planes.arrayBuffer()]);
  const planes = new Uint8Array(pixels);
  const found = JSON.parse(run(photo.width, photo.height, planes));
  if (look === 'faces') found.boxes = await withExpressions(found.boxes, photo, planes, slow);
  const all = look === 'closer' ? await withExpressions(found, photo, planes, slow) : found;
  detach(planes);
  return all;
}

/** Adds eyes and mouths to large faces. Without the landmark model, it returns the boxes unchanged. */
async function withExpressions(
  boxes: readonly Detection[],
  { width, height }: PhotoHandle,
  planes: Uint8Array,
  slow: Slow,
): Promise<readonly Detection[]> {
  if (!reader || boxes.length === 0) return boxes;
  const text = JSON.stringify(boxes);
  try {
    const { FaceReader } = await module();
    if (!FaceReader.suits(width, height, text)) return boxes;
    slow();
    const net = await reader.ready();
    return JSON.parse(net.read(width, height, planes, text));
  } catch {
    return boxes;
  }
}

/**
 * @param boxes of the first look
 * @param known the objects of the photo
 */
async function runner(
  look: Exclude<Look, 'lips'>,
  boxes: readonly Detection[] = [],
  known: readonly Detection[] = [],
): Promise<(width: number, height: number, planes: Uint8Array) => string> {
  if (look === 'objects') {
    const net = await objects.ready();
    return (...photo) => net.look(...photo);
  }
  const net = await faces.ready();
  if (look === 'faces') return (...photo) => net.look(...photo);
  return (...photo) => net.look_closer(...photo, JSON.stringify(boxes), JSON.stringify(known));
}
