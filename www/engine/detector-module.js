// @ts-check
/** What the workers of all nets begin with: the module that they share, and the file of a net. */

import initDetector from '../pkg-detector/inkpanel.js';
import { fetchKept, isPage } from './kept.js';
import { failure } from './protocol.js';

const MODULE = new URL('../pkg-detector/inkpanel_bg.wasm', import.meta.url);

/**
 * A net in two steps: `load` fetches what it needs, which costs hardly any time of a core; `ready` gives the net, made at
 * the first call. What failed is tried again when it is asked for again.
 * @template T
 * @param {URL | string} address
 * @param {(net: Uint8Array) => T} make
 * @returns {{ load: () => Promise<unknown>, ready: () => Promise<T> }}
 */
export function net(address, make) {
  const files = onceMore(() => Promise.all([MODULE, address].map(load)));
  const made = onceMore(async () => {
    const [module, onnx] = await files.get();
    await initDetector({ module_or_path: module });
    const net = make(new Uint8Array(onnx));
    files.forget();
    return net;
  });
  return { load: files.get, ready: made.get };
}

/**
 * A promise that is made when it is first asked for, and anew after it failed.
 * @template T
 * @param {() => Promise<T>} begin
 */
function onceMore(begin) {
  /** @type {Promise<T> | undefined} */
  let begun;
  const forget = () => { begun = undefined; };
  const get = () => {
    begun ??= begin().catch((error) => {
      forget();
      throw error;
    });
    return begun;
  };
  return { get, forget };
}

/** @param {URL | string} address */
async function load(address) {
  const response = await fetchKept(String(address)).catch(() => null);
  if (!response?.ok || isPage(response)) throw failure('detector-missing', 'The detectors could not be loaded.');
  return response.arrayBuffer();
}
