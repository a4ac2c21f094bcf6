/** The worker of a detector, for faces or for objects. It loads the shared module and one model with the first job. */

import { detach } from './blobs.ts';
import { net } from './detector-module.ts';
import { serveJobs } from './serving.ts';
import type { Detection } from './types.ts';
import type { Looking } from './protocol.ts';
import type { Work } from './serving.ts';

const faces = net(new URL('../models/faces.onnx', import.meta.url), ({ FaceDetector }, onnx) => new FaceDetector(onnx));
const objects = net(
  new URL('../models/objects.onnx', import.meta.url),
  ({ ObjectDetector }, onnx) => new ObjectDetector(onnx),
);

export type Look = 'faces' | 'closer' | 'objects';

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
  faces: async (args) => ({ ok: await looked('faces', args) }),
  closer: async (args) => ({ ok: await looked('closer', args) }),
  objects: async (args) => ({ ok: await looked('objects', args) }),
};

serveJobs<Looking>((op, args, slow) => OPERATIONS[op](args, slow));

function named({ net }: Looking['load']['args']) {
  return net === 'faces' ? faces : objects;
}

async function looked<Op extends Look>(look: Op, { photo, boxes }: Looking[Op]['args']): Promise<Looking[Op]['ok']> {
  const [run, pixels] = await Promise.all([runner(look, boxes), photo.planes.arrayBuffer()]);
  const planes = new Uint8Array(pixels);
  const found = run(photo.width, photo.height, planes);
  detach(planes);
  return JSON.parse(found);
}

/** @param boxes of the first look */
async function runner(
  look: Look,
  boxes?: readonly Detection[],
): Promise<(width: number, height: number, planes: Uint8Array) => string> {
  if (look === 'objects') {
    const net = await objects.ready();
    return (...photo) => net.look(...photo);
  }
  const net = await faces.ready();
  return (...photo) => (look === 'faces' ? net.look(...photo) : net.look_closer(...photo, JSON.stringify(boxes)));
}
