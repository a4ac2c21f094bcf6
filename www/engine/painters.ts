/**
 * The models of the block Painter. A worker loads the built-in one before the first job whose style has the block, and
 * the browser stores it for offline use. Models of the user come with the jobs whose styles name them.
 */

import { fetchKept, isPage } from './kept.ts';
import { onceMore } from './once-more.ts';
import { failure } from './protocol.ts';
import type { Studio } from '../pkg/inkpanel.js';

/** Models of the user by the hash in their references. */
export type OwnFiles = Readonly<Record<string, Blob>>;
/** Returns the models that are there. */
export type FindOwn = (ids: readonly string[]) => Promise<OwnFiles>;

const MODEL = new URL('../models/painters.onnx', import.meta.url);

/** The block, or the id of a built-in style with the block. */
const MENTIONED = /(^|")painter(-|"|$)/;

/** A reference, inside JSON and as a separate text: a hash and the name of a file. */
const NAMED = /"model":"([0-9a-f]{16}) /g;
const REFERENCE = /^([0-9a-f]{16}) /;

/** @param args of an operation: styles and documents as JSON or as plain data; binary data is ignored */
export function mentionsPainter(args: unknown): boolean {
  if (typeof args === 'string') return MENTIONED.test(args);
  if (Array.isArray(args)) return args.some(mentionsPainter);
  const plain = typeof args === 'object' && args !== null && Object.getPrototypeOf(args) === Object.prototype;
  return plain && Object.values(args).some(mentionsPainter);
}

/**
 * @param args as for `mentionsPainter`
 * @returns the hashes of the models of the user that styles name
 */
export function ownModelsIn(args: unknown): string[] {
  const found = new Set<string>();
  const look = (value: unknown, key = '') => {
    if (typeof value === 'string') {
      for (const [, id] of value.matchAll(NAMED)) found.add(id);
      const [, alone] = (key === 'model' && REFERENCE.exec(value)) || [];
      if (alone) found.add(alone);
    } else if (Array.isArray(value)) {
      for (const item of value) look(item);
    } else if (typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype) {
      for (const [name, item] of Object.entries(value)) look(item, name);
    }
  };
  look(args);
  return [...found];
}

/** The built-in model. Rejects with `painters-missing`, and is loaded again at the next call. */
export const { get: paintersFile } = onceMore(async () => {
  const response = await fetchKept(String(MODEL)).catch(() => null);
  if (!response?.ok || isPage(response)) {
    throw failure('painters-missing', 'The painters could not be loaded. Try again with a connection.');
  }
  return new Uint8Array(await response.arrayBuffer());
});

/** @returns the arguments of an operation with the models of the user that it needs */
export async function withOwnModels<Args>(args: Args, find: FindOwn | undefined): Promise<Args> {
  const ids = ownModelsIn(args);
  return find && ids.length > 0 ? { ...args, own: await find(ids) } : args;
}

/**
 * Gives the models to a module that draws, each once.
 * @returns a function that prepares the module for a job
 */
export function paintersLoader(
  studio: Pick<Studio, 'know_painters' | 'know_own_painters' | 'forget_own_painters'>,
): (args: unknown) => Promise<void> {
  const builtIn = onceMore(async () => studio.know_painters(await paintersFile()));
  const known = new Set<string>();
  return async (args) => {
    const { own = {} } = args as { own?: OwnFiles };
    const brought = Object.entries(own);
    await builtIn.get().catch((error) => {
      // Without a connection, the model of the user is enough.
      if (brought.length === 0) throw error;
    });
    // The user removed a model that is still here.
    if (ownModelsIn(args).some((id) => known.has(id) && !own[id])) {
      studio.forget_own_painters();
      known.clear();
    }
    for (const [id, file] of brought) {
      if (known.has(id)) continue;
      studio.know_own_painters(id, new Uint8Array(await file.arrayBuffer()));
      known.add(id);
    }
  };
}
