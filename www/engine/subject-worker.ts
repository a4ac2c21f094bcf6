/**
 * The worker of the subject model. It loads the detector module and the model with the first job. A job is one slice of
 * a detection. If the slice before belonged to another detection or a lost worker, the detection begins again.
 */

import { detach } from './blobs.ts';
import { net } from './detector-module.ts';
import { LOOKS } from './measured.ts';
import { LOADING, serveJobs } from './serving.ts';
import type { SubjectLook, SubjectNet } from '../pkg-detector/inkpanel.js';
import type { Masking } from './protocol.ts';
import type { Tell } from './serving.ts';

/**
 * Milliseconds of one slice of work. A slice ends with its current operator: most take less than 1 ms, the largest up
 * to a second.
 */
const PART = 25;

let subjects: { ready: () => Promise<SubjectNet> } | undefined;
let current: { look: number; steps: SubjectLook } | undefined;

serveJobs<Masking>(async (_, args, tell) => {
  if (current?.look !== args.look) {
    leave();
    current = { look: args.look, steps: await begun(args, tell) };
  }
  tell.expects(LOOKS.mask);
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

async function begun({ photo, net: address }: Masking['mask']['args'], tell: Tell): Promise<SubjectLook> {
  tell.waits(LOADING);
  subjects ??= net(address, ({ SubjectNet }, onnx) => new SubjectNet(onnx));
  const [subject, pixels] = await Promise.all([subjects.ready(), photo.planes.arrayBuffer()]);
  tell.expects(LOOKS.mask);
  const planes = new Uint8Array(pixels);
  const steps = subject.begin(photo.width, photo.height, planes);
  detach(planes);
  return steps;
}

function leave() {
  current?.steps.free();
  current = undefined;
}
