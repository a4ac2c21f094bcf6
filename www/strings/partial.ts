/** Incomplete translations: missing texts appear in English. */

import type { Names } from './names.ts';
import type { Words } from './en/index.ts';

/**
 * The same type with optional fields. Functions and lists are never partial. Names that every object has (`valueOf`)
 * are excluded, because no object lacks them.
 */
export type PartOf<T> = T extends ((...given: never[]) => unknown) | readonly unknown[]
  ? T
  : T extends object
    ? { [K in keyof T as K extends keyof Object ? never : K]?: PartOf<T[K]> }
    : T;

/** A folder of `strings/` with possibly missing texts. */
export type PartTranslation = { words: PartOf<Words>; names: Names };

const isGroup = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** @returns the fields of `whole`, replaced by fields of `part` with the same name, and additional fields of `part` */
export function filled<T extends object>(part: NoInfer<PartOf<T>>, whole: T): T {
  const out: Record<string, unknown> = Object.fromEntries(Object.entries(whole));
  for (const [key, value] of Object.entries(part)) {
    const below = out[key];
    out[key] = isGroup(value) && isGroup(below) ? filled(value, below) : (value ?? below);
  }
  return out as T;
}
