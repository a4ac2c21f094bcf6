/** Builds all strings of the app from a language's messages and names, and from the formats of a locale. */

import { formatsIn } from './formats.ts';
import { naming } from './names.ts';
import { numbersIn } from './numbers.ts';
import type { Messages } from './compiled/en.ts';
import type { Formats } from './formats.ts';
import type { Names } from './names.ts';

/** A module of `compiled/`. */
export type Translation = { messages: (formats: Formats) => Messages; names?: Partial<Names> };

/** How many of a kind of thing. */
export type Seen = { label: string; count: number };

/** Maximum number of names in a list. Further names are counted. */
const MAX_NAMES = 3;
/** Placeholders for the arguments of a message. Names never contain them. */
const [NAME, NUMBER] = ['\u0001', '\u0002'];

/** @returns the text at this key, for keys that the core or a file defines */
export const textAt = (texts: Readonly<Record<string, string>>, key: string): string | undefined =>
  Object.hasOwn(texts, key) ? texts[key] : undefined;

/**
 * @param language selects the plural forms
 * @param locale selects the formats of numbers and lists
 */
export function compose(language: string, { messages, names }: Translation, locale = language) {
  const numbers = numbersIn(locale);
  const texts = messages(formatsIn(language, numbers));
  const { things, numerals } = texts;

  function thing({ label, count }: Seen): string {
    const named = things[label as keyof typeof things];
    return named?.({ count, number: textAt(numerals, `${count}`) ?? numbers.decimal(count) }) ?? label;
  }

  /** @returns a pattern of a message, with a group for each argument */
  const patternOf = (text: string) =>
    new RegExp(
      `^${text
        .replaceAll(/[\\^$.*+?()[\]{}|]/g, '\\$&')
        .replace(NAME, '(.*)')
        .replace(NUMBER, '(\\d+)')}$`,
      's',
    );

  /** @returns `Ink copy` for `Ink`, and `Ink copy 2` for `Ink copy` */
  function nameOfCopy(name: string): string {
    const again = patternOf(texts.copyAgain({ name: NAME, n: NUMBER })).exec(name);
    if (again) return texts.copyAgain({ name: again[1], n: `${Number(again[2]) + 1}` });
    const once = patternOf(texts.copyOf({ name: NAME })).exec(name);
    return once ? texts.copyAgain({ name: once[1], n: '2' }) : texts.copyOf({ name });
  }

  return {
    name: 'Inkpanel',
    ...numbers,
    ...texts,
    ...naming(texts, names),
    nameOfCopy,
    frameName: (name: string, seconds: number) => `${name}, ${numbers.clock(seconds)}`,
    /** @returns `two people and a dog`; empty for an empty list */
    seen: (seen: readonly Seen[]) => numbers.listed(seen.map(thing)),
    /** @returns several sentences as one text */
    sentences: (said: readonly string[]) =>
      said.length === 0 ? '' : said.reduce((first, second) => texts.twoSentences({ first, second })),
    /** @returns the first names, and the number of the others */
    someNames: (all: readonly string[]) => {
      if (all.length === 0) return '';
      const first = all.slice(0, MAX_NAMES).reduce((first, second) => texts.twoNames({ first, second }));
      const n = all.length - MAX_NAMES;
      return n > 0 ? texts.namesAndMore({ names: first, n }) : first;
    },
  };
}
