/**
 * Time limits of worker jobs, in milliseconds. `pool.ts` replaces a worker that exceeds the limit of its operation, and
 * doubles the limit for the last attempt. The limits suit a phone that is ten times slower than a desktop computer.
 */

import type { Hearing, Judging, Looking, Making, Masking, Operations, Wording } from './protocol.ts';

type Operation = keyof (Operations & Looking & Making & Masking & Judging & Wording & Hearing);

/** One picture at the size of the screen. */
const SHORT = 20_000;
/** A photo of up to 32 MB, or many small pictures. */
const MEDIUM = 30_000;
/** Pictures at full size, files, downloads on a slow connection, and painted pictures. */
export const LONG = 300_000;

const LIMITS: Partial<Record<Operation, number>> = {
  import: MEDIUM,
  draft: MEDIUM,
  importFrame: MEDIUM,
  living: MEDIUM,
  page: MEDIUM,
  explore: MEDIUM,
  tryLooks: MEDIUM,
  readLook: MEDIUM,
  compose: LONG,
  stylize: LONG,
  fullPanels: LONG,
  cutOut: LONG,
  encode: LONG,
  load: LONG,
  make: LONG,
  jpeg: LONG,
  webp: LONG,
  losslessWebp: LONG,
  losslessPicture: LONG,
  pictures: LONG,
  pdf: LONG,
  comic: LONG,
  board: LONG,
  strip: LONG,
  shots: LONG,
  animatic: LONG,
  motion: LONG,
  track: LONG,
  sounds: LONG,
};

export function limitOf(op: PropertyKey): number {
  return LIMITS[op as Operation] ?? SHORT;
}
