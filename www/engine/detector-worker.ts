/**
 * The worker of a detector, of the one for faces or of the one for objects: the module that both have, and one net,
 * loaded with the first job.
 */

import { net } from './detector-module.ts';
import { LOOKS } from './measured.ts';
import { LOADING, serveJobs } from './serving.ts';
import type { Found } from './detector.ts';
import type { PhotoHandle } from './protocol.ts';
import type { Tell } from './serving.ts';

const faces = net(new URL('../models/faces.onnx', import.meta.url), ({ FaceDetector }, onnx) => new FaceDetector(onnx));
const objects = net(
  new URL('../models/objects.onnx', import.meta.url),
  ({ ObjectDetector }, onnx) => new ObjectDetector(onnx),
);

export type Look = 'faces' | 'closer' | 'objects';
type Order =
  | { op: 'load' | 'make'; args: { net: 'faces' | 'objects' } }
  | { op: Look; args: { photo: PhotoHandle; boxes?: Found[] } };

serveJobs(async (op, args, tell) => ({ ok: await obey({ op, args } as Order, tell) }));

async function obey({ op, args }: Order, tell: Tell) {
  tell.waits(LOADING);
  if ('net' in args) {
    const { load, ready } = args.net === 'faces' ? faces : objects;
    await (op === 'load' ? load() : ready());
    return null;
  }
  const { photo, boxes } = args;
  const look = op as Look;
  const [run, pixels] = await Promise.all([runner(look, boxes), photo.planes.arrayBuffer()]);
  tell.expects(LOOKS[look]);
  return JSON.parse(run(photo.width, photo.height, new Uint8Array(pixels)));
}

/** @param boxes of the first look */
async function runner(
  look: Look,
  boxes?: Found[],
): Promise<(width: number, height: number, planes: Uint8Array) => string> {
  if (look === 'objects') {
    const net = await objects.ready();
    return (...photo) => net.look(...photo);
  }
  const net = await faces.ready();
  return (...photo) => (look === 'faces' ? net.look(...photo) : net.look_closer(...photo, JSON.stringify(boxes)));
}
