// @ts-check
/** What the workers of all nets begin with: the module that they share, and the file of a net. */

import initDetector from '../pkg-detector/inkpanel.js';
import { fetchKept, isPage } from './kept.js';
import { failure } from './protocol.js';

const MODULE = new URL('../pkg-detector/inkpanel_bg.wasm', import.meta.url);

/**
 * A net, ready to be asked; what could not be loaded is tried again when it is asked for again.
 * @template T
 * @param {URL | string} address
 * @param {(net: Uint8Array) => T} make
 * @returns {() => Promise<T>}
 */
export function net(address, make) {
  /** @type {Promise<T> | undefined} */
  let made;
  return () => {
    made ??= start(address).then(make).catch((error) => {
      made = undefined;
      throw error;
    });
    return made;
  };
}

/**
 * The module, ready.
 * @param {URL | string} address of a net
 * @returns {Promise<Uint8Array>} the net
 */
async function start(address) {
  const [module, onnx] = await Promise.all([MODULE, address].map(load));
  await initDetector({ module_or_path: module });
  return new Uint8Array(onnx);
}

/** @param {URL | string} address */
async function load(address) {
  const response = await fetchKept(String(address)).catch(() => null);
  if (!response?.ok || isPage(response)) throw failure('detector-missing', 'The detectors could not be loaded.');
  return response.arrayBuffer();
}
