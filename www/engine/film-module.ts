/** The wasm module that finds the shots of videos, loaded with the first video. */

import { moduleBytes } from './module-bytes.ts';

const MODULE = new URL('../pkg-films/inkpanel_bg.wasm', import.meta.url);

type Films = typeof import('../pkg-films/inkpanel.js');

/** @throws `films-missing` */
export async function filmModule(): Promise<Films> {
  const bytes = await moduleBytes(
    MODULE,
    'films-missing',
    'What reads films could not be loaded. Try again with a connection.',
  );
  const module = await import('../pkg-films/inkpanel.js');
  await module.default({ module_or_path: bytes });
  return module;
}
