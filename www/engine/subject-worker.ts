/**
 * The worker of the subject model. It loads the detector module and the model with the first job. A job is one slice of
 * a detection. If the slice before belonged to another detection or a lost worker, the detection begins again.
 */

import { detach } from './blobs.ts';
import { net } from './detector-module.ts';
import { serveJobs } from './serving.ts';
import type { SubjectLook, SubjectNet } from '../pkg-detector/inkpanel.js';
import type { Slow } from './serving.ts';
import type { Masking } from './protocol.ts';

/**
 * Milliseconds of one slice of work. A slice ends with its current operator: most take less than 1 ms, the largest up
 * to a second.
 */
const PART = 25;

let subjects: { ready: () => Promise<SubjectNet> } | undefined;
let current: { look: number; steps: SubjectLook } | undefined;

serveJobs<Masking>(async (_, args, slow) => {
  if (current?.look !== args.look) {
    leave();
    current = { look: args.look, steps: await begun(args, slow) };
  }
  const { steps } = current;
  const end = performance.now() + PART;
  try {
    let mask: string | undefined;
    while (mask === undefined && performance.now() < end) mask = steps.advance();
    if (mask !== undefined) leave();
    return { ok: mask ?? null };
  } catch (error) {
    leave();
    throw error;
  }
});

async function begun({ photo, net: address }: Masking['mask']['args'], slow: Slow): Promise<SubjectLook> {
  if (!subjects) slow();
  subjects ??= net(address, ({ SubjectNet }, onnx) => new SubjectNet(onnx));
  const [subject, pixels] = await Promise.all([subjects.ready(), photo.planes.arrayBuffer()]);
  const planes = new Uint8Array(pixels);
  const steps = subject.begin(photo.width, photo.height, planes);
  detach(planes);
  return steps;
}

function leave() {
  current?.steps.free();
  current = undefined;
}
