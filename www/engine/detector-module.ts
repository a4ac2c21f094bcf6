/** Shared start of all detector workers: the wasm module and the file of a model. */

import { fetchKept, isPage } from './kept.ts';
import { MODULE, SCRIPT } from './nets-files.ts';
import { onceMore } from './once-more.ts';
import { failure } from './protocol.ts';

type Nets = typeof import('../pkg-detector/inkpanel.js');

/** The files of the module, and the module, which starts once per worker. */
const code = onceMore(() => Promise.all([script(), load(MODULE)]));
const started = onceMore(async () => {
  const [nets, module] = await code.get();
  await nets.default({ module_or_path: module });
  code.forget();
  return nets;
});

/** The module. */
export const module = started.get;

/**
 * Loads a model in two steps. `load` fetches its files, at little processor time. `ready` returns the model and creates
 * it at the first call. The next call retries after a failure.
 */
export function net<T>(
  address: URL | string,
  make: (nets: Nets, net: Uint8Array) => T,
): { load: () => Promise<unknown>; ready: () => Promise<T> } {
  const file = onceMore(() => load(address));
  const made = onceMore(async () => {
    const [nets, onnx] = await Promise.all([started.get(), file.get()]);
    const net = make(nets, new Uint8Array(onnx));
    file.forget();
    return net;
  });
  return { load: () => Promise.all([code.get(), file.get()]), ready: made.get };
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
