// @ts-check
/** What the workers of all nets begin with: the module that they share, and the file of a net. */

import initDetector from '../pkg-detector/inkpanel.js';
import { failure } from './protocol.js';

const MODULE = new URL('../pkg-detector/inkpanel_bg.wasm', import.meta.url);

/**
 * The module, ready.
 * @param {URL | string} address of a net
 * @returns {Promise<Uint8Array>} the net
 */
export async function start(address) {
  const [module, net] = await Promise.all([MODULE, address].map(load));
  await initDetector({ module_or_path: module });
  return new Uint8Array(net);
}

/** @param {URL | string} address */
async function load(address) {
  const response = await fetch(address).catch(() => null);
  const text = response?.headers.get('content-type')?.startsWith('text/html');
  // A host may answer with a page of its own where a file is missing.
  if (!response?.ok || text) throw failure('detector-missing', 'The detectors could not be loaded.');
  return response.arrayBuffer();
}
