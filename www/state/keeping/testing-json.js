// @ts-check
/** JSON that is counted before it is parsed, as the core counts it, for tests without the core. */

import { failure } from '../../engine/protocol.js';

/** As `src/document/limits.rs` has it, about. */
const MOST = { depth: 64, values: 2_000_000, items: 10_000, string: 100_000 };

const [QUOTE, BACKSLASH, COMMA] = ['"', '\\', ','].map((sign) => sign.charCodeAt(0));
const [LIST, LIST_END, OBJECT, OBJECT_END] = ['[', ']', '{', '}'].map((sign) => sign.charCodeAt(0));

/**
 * @param {string} text
 * @param {{ depth: number, values: number, items: number, string: number }} [most]
 * @returns {any} what it says; throws a `SyntaxError`, or `too-large-project` where it is beyond `most`
 */
export function parsedJson(text, most = MOST) {
  let values = 0;
  /** How much there is in each of the lists and objects that are open. @type {number[]} */
  const open = [];
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

/** @param {string} text @param {number} start where it begins @returns {number} where its last quote is, or where the text ends */
function endOfString(text, start) {
  for (let at = start + 1; at < text.length; at += 1) {
    const sign = text.charCodeAt(at);
    if (sign === QUOTE) return at;
    if (sign === BACKSLASH) at += 1;
  }
  return text.length;
}

/** @param {string} what */
function tooLarge(what) {
  return failure('too-large-project', `project.json: ${what} in it is beyond all measure.`);
}
