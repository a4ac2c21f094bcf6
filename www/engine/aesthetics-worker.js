// @ts-check
/** The worker of the net that scores pictures: the detectors' module and the net, loaded with the first job. */

import { net } from './detector-module.js';
import { LOOKS } from './measured.js';
import { LOADING, serveJobs } from './serving.js';

/** @type {{ ready: () => Promise<import('../pkg-detector/inkpanel.js').AestheticsNet> } | undefined} */
let judgeNet;

serveJobs(async (_, /** @type {{ width: number, height: number, data: Uint8ClampedArray, net: string }} */ { width, height, data, net: address }, tell) => {
  tell.waits(LOADING);
  judgeNet ??= net(address, ({ AestheticsNet }, onnx) => new AestheticsNet(onnx));
  const judge = await judgeNet.ready();
  tell.expects(LOOKS.judge);
  return { ok: judge.score(width, height, new Uint8Array(data.buffer, data.byteOffset, data.length)) };
});
