/** A language that says only part of what English says: English shows through. */

import type { Names } from './names.ts';
import type { Words } from './en/index.ts';

/**
 * The same shape, of which everything may be missing: sentences and lists are there as a whole or not at all. Names that every
 * object has (`valueOf`) are not looked at, as none is without them.
 */
export type PartOf<T> = T extends ((...given: never[]) => unknown) | readonly unknown[]
  ? T
  : T extends object
    ? { [K in keyof T as K extends keyof Object ? never : K]?: PartOf<T[K]> }
    : T;

/** A folder of `strings/` in which words may be missing. */
export type PartTranslation = { words: PartOf<Words>; names: Names };

const isGroup = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** @returns all that `whole` has, each in the words of `part` where there are some, and what `part` alone has */
export function filled<T extends object>(part: NoInfer<PartOf<T>>, whole: T): T {
  const out: Record<string, unknown> = Object.fromEntries(Object.entries(whole));
  for (const [key, value] of Object.entries(part)) {
    const below = out[key];
    out[key] = isGroup(value) && isGroup(below) ? filled(value, below) : (value ?? below);
  }
  return out as T;
}
