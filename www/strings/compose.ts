/** Builds all strings of the app from a language's texts and names, and from the formats of a locale. */

import { naming } from './names.ts';
import { numbersIn } from './numbers.ts';
import type { Names } from './names.ts';
import type { Words } from './en/index.ts';

/** A folder of `strings/`. */
export type Translation = { words: Words; names: Names };

/** How many of a kind of thing. */
export type Seen = { label: string; count: number };

/** Functions for plurals, passed to the languages, because language files import no code. */
export type Counted = typeof counted;

/**
 * @param numerals from two on, at their number; larger numbers are digits
 * @returns `a dog`, `two dogs`
 */
function counted(count: number, [one, many]: readonly [string, string], numerals: readonly string[]): string {
  return count === 1 ? one : `${numerals[count] ?? count} ${many}`;
}

/** @param locale how numbers and lists are written */
export function compose(locale: string, { words, names }: Translation) {
  const numbers = numbersIn(locale);
  return {
    name: 'Inkpanel',
    ...numbers,
    ...naming(names),
    ...words,
    frameName: (name: string, seconds: number) => `${name}, ${numbers.clock(seconds)}`,
    /** @returns `two people and a dog`; empty for an empty list */
    seen: (things: readonly Seen[]) => numbers.listed(things.map((thing) => words.thing(thing, counted))),
  };
}
