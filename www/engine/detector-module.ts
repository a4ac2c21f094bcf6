/** What the workers of all nets begin with: the module that they share, and the file of a net. */

import { fetchKept, isPage } from './kept.ts';
import { MODULE, SCRIPT } from './nets-files.ts';
import { onceMore } from './once-more.ts';
import { failure } from './protocol.ts';

type Nets = typeof import('../pkg-detector/inkpanel.js');

/**
 * A net in two steps: `load` fetches what it needs, which costs hardly any time of a core; `ready` gives the net, made at
 * the first call. What failed is tried again when it is asked for again.
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
