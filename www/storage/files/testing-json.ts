/** JSON that is counted before it is parsed, as the core counts it, for tests without the core. */

import { failure } from '../../engine/protocol.ts';

/** As `src/document/limits.rs` has it, about. */
const MOST = { depth: 64, values: 2_000_000, items: 10_000, string: 100_000 };

const [QUOTE, BACKSLASH, COMMA] = ['"', '\\', ','].map((sign) => sign.charCodeAt(0));
const [LIST, LIST_END, OBJECT, OBJECT_END] = ['[', ']', '{', '}'].map((sign) => sign.charCodeAt(0));

/** @returns what it says; throws a `SyntaxError`, or `too-large-project` where it is beyond `most` */
export function parsedJson(
  text: string,
  most: { depth: number; values: number; items: number; string: number } = MOST,
): any {
  let values = 0;
  /** How much there is in each of the lists and objects that are open. */
  const open: number[] = [];
  for (let at = 0; at < text.length; at += 1) {
    const sign = text.charCodeAt(at);
    if (sign === QUOTE) {
      const end = endOfString(text, at);
      if (end - at - 1 > most.string) throw tooLarge('a text');
      at = end;
    } else if (sign === COMMA) {
      values += 1;
      open[open.length - 1] += 1;
      if (open[open.length - 1] > most.items) throw tooLarge('a list');
    } else if (sign === LIST || sign === OBJECT) {
      values += 1;
      open.push(1);
      if (open.length > most.depth) throw tooLarge('a list of lists');
    } else if (sign === LIST_END || sign === OBJECT_END) {
      open.pop();
    }
    if (values > most.values) throw tooLarge('the number of its parts');
  }
  return JSON.parse(text);
}

/**
 * @param start where it begins
 * @returns where its last quote is, or where the text ends
 */
function endOfString(text: string, start: number): number {
  for (let at = start + 1; at < text.length; at += 1) {
    const sign = text.charCodeAt(at);
    if (sign === QUOTE) return at;
    if (sign === BACKSLASH) at += 1;
  }
  return text.length;
}

function tooLarge(what: string) {
  return failure('too-large-project', `project.json: ${what} in it is beyond all measure.`);
}
