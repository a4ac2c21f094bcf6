// @ts-check
/** The worker of the net that scores pictures: the detectors' module and the net, loaded with the first job. */

import { AestheticsNet } from '../pkg-detector/inkpanel.js';
import { net } from './detector-module.js';
import { describe } from './protocol.js';

/** @type {{ ready: () => Promise<AestheticsNet> } | undefined} */
let judgeNet;

/** @param {MessageEvent<{ id: number, op: 'judge', args: { width: number, height: number, data: Uint8ClampedArray, net: string } }>} event */
globalThis.onmessage = async ({ data: { id, args: { width, height, data, net: address } } }) => {
  try {
    judgeNet ??= net(address, (onnx) => new AestheticsNet(onnx));
    const judge = await judgeNet.ready();
    postMessage({ id, ok: judge.score(width, height, new Uint8Array(data.buffer, data.byteOffset, data.length)), memory: 0 });
  } catch (error) {
    postMessage({ id, error: describe(error), memory: 0 });
  }
};
