/** The worker of the net that finds what a photo shows: the detectors' module and the net, loaded with the first job. */

import { detach } from './blobs.ts';
import { net } from './detector-module.ts';
import { LOOKS } from './measured.ts';
import { LOADING, serveJobs } from './serving.ts';
import type { SubjectNet } from '../pkg-detector/inkpanel.js';
import type { Masking } from './protocol.ts';

let subjects: { ready: () => Promise<SubjectNet> } | undefined;

serveJobs<Masking>(async (_, { photo, net: address }, tell) => {
  tell.waits(LOADING);
  subjects ??= net(address, ({ SubjectNet }, onnx) => new SubjectNet(onnx));
  const [subject, pixels] = await Promise.all([subjects.ready(), photo.planes.arrayBuffer()]);
  tell.expects(LOOKS.mask);
  const planes = new Uint8Array(pixels);
  const ok = subject.look(photo.width, photo.height, planes);
  detach(planes);
  return { ok };
});
