/** Shared start of all detector workers: the wasm module and the file of a model. */

import { fetchKept, isPage } from './kept.ts';
import { MODULE, SCRIPT } from './nets-files.ts';
import { onceMore } from './once-more.ts';
import { failure } from './protocol.ts';

type Nets = typeof import('../pkg-detector/inkpanel.js');

/**
 * Loads a model in two steps. `load` fetches its files, at little processor time. `ready` returns the model and creates
 * it at the first call. The next call retries after a failure.
 */
export function net<T>(
  address: URL | string,
  make: (nets: Nets, net: Uint8Array) => T,
): { load: () => Promise<unknown>; ready: () => Promise<T> } {
  const files = onceMore(() => Promise.all([script(), load(MODULE), load(address)]));
  const made = onceMore(async () => {
    const [nets, module, onnx] = await files.get();
    await nets.default({ module_or_path: module });
    const net = make(nets, new Uint8Array(onnx));
    files.forget();
    return net;
  });
  return { load: files.get, ready: made.get };
}

/** @returns the script of the module */
function script(): Promise<Nets> {
  return import(/* @vite-ignore */ SCRIPT.href).catch(() => {
    throw missing();
  });
}

async function load(address: URL | string) {
  const response = await fetchKept(String(address)).catch(() => null);
  if (!response?.ok || isPage(response)) throw missing();
  return response.arrayBuffer();
}

function missing() {
  return failure('detector-missing', 'The detectors could not be loaded.');
}
