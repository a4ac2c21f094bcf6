/** The worker of the image-aesthetics model. It loads the detector module and the model with the first job. */

import { detach } from './blobs.ts';
import { net } from './detector-module.ts';
import { serveJobs } from './serving.ts';
import type { AestheticsNet } from '../pkg-detector/inkpanel.js';
import type { Judging } from './protocol.ts';

let judgeNet: { ready: () => Promise<AestheticsNet> } | undefined;

serveJobs<Judging>(async (_, { width, height, data, net: address }, slow) => {
  if (!judgeNet) slow();
  judgeNet ??= net(address, ({ AestheticsNet }, onnx) => new AestheticsNet(onnx));
  const judge = await judgeNet.ready();
  const ok = judge.score(width, height, new Uint8Array(data.buffer, data.byteOffset, data.length));
  detach(data);
  return { ok };
});
