/**
 * The module for styles from a picture: it measures pictures, tries styles and controls the search. The main thread and
 * each worker that tries styles load it on demand.
 */

import { moduleBytes } from './module-bytes.ts';
import { onceMore } from './once-more.ts';
import type { Trial } from './protocol.ts';
import type { Style } from './types.ts';

const MODULE = new URL('../pkg-imitation/inkpanel_bg.wasm', import.meta.url);

type Imitating = typeof import('../pkg-imitation/inkpanel.js');

/** The module. It is loaded once, and again after an error. Rejects with `imitation-missing`. */
export const { get: imitating } = onceMore(load);

async function load(): Promise<Imitating> {
  const bytes = await moduleBytes(
    MODULE,
    'imitation-missing',
    'What finds styles in pictures could not be loaded. Try again with a connection.',
  );
  const module = await import('../pkg-imitation/inkpanel.js');
  await module.default({ module_or_path: bytes });
  return module;
}

/** The first trials of most searches, independent of the picture. */
export async function surveyed(): Promise<Trial[]> {
  return JSON.parse((await imitating()).survey());
}

/**
 * A search for styles that look like a picture. Free it after use.
 * @param look of the picture, from a worker
 */
export async function beginSearch(look: string, seed: number) {
  const search = new (await imitating()).Imitation(look, seed);
  return {
    /** @returns the next trials; empty at the end */
    ask: (): Trial[] => JSON.parse(search.ask()),
    /** @param trials results of the trials, in order */
    tell: (trials: readonly (string | null)[]) => search.tell(`[${trials.map((one) => one ?? 'null').join()}]`),
    /** Progress, 0 to 1, after `tried` of the last requested trials. */
    progress: (tried: number) => search.progress(tried),
    proposals: (): Style[] => JSON.parse(search.proposals()),
    free: () => search.free(),
  };
}
