/** Loads the core: the program, and the functions that call it. */

import { fetchAsset } from './assets.ts';
import { failure } from './protocol.ts';
import { nextTask, pause } from './scheduler.ts';
import { SHARES_CODE } from './shared-code.ts';
import type { Planner } from './core.ts';
import type { Program } from './protocol.ts';

const ADDRESS = new URL('../pkg/inkpanel_bg.wasm', import.meta.url);

/** Maximum wait for the first pictures in milliseconds, and in a background tab, which never paints. */
const [UNPAINTED, HIDDEN] = [1_000, 50];

/** Waits until the pictures of the page are painted, which downloads and compilation would delay, by seconds on a phone. */
function painted(): Promise<void> {
  const { document, requestAnimationFrame } = globalThis;
  if (!document || !requestAnimationFrame) return Promise.resolve();
  const loaded = new Promise<unknown>((done) => {
    if (document.readyState === 'complete') done(null);
    else globalThis.addEventListener('load', done, { once: true });
  });
  const frame = loaded.then(() => new Promise((done) => requestAnimationFrame(done))).then(nextTask);
  return Promise.race([frame, pause(document.hidden ? HIDDEN : UNPAINTED)]);
}

async function load(): Promise<Program> {
  const response = await fetchAsset(ADDRESS);
  if (!response.ok) throw failure('core-missing', `The program could not be loaded (${response.status}).`);
  // A static host may serve wasm under any content type, which streaming would refuse.
  const streams = response.headers.get('content-type')?.startsWith('application/wasm');
  if (SHARES_CODE && streams) return WebAssembly.compileStreaming(response);
  const bytes = await response.arrayBuffer();
  return SHARES_CODE ? WebAssembly.compile(bytes) : bytes;
}

export async function loadCore(): Promise<{ program: Program; planner: Planner }> {
  await painted();
  const [program, { startCore }] = await Promise.all([load(), import('./core.ts')]);
  return { program, planner: await startCore(program) };
}
