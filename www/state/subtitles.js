// @ts-check
/**
 * Subtitles as SubRip (.srt) and WebVTT (.vtt) files have them. What is malformed is an error that names the line.
 */

import { strings } from '../strings.js';

/** @typedef {{ start: number, end: number, text: string }} Cue seconds, and the text without marks */

/** What `readSubtitles` gives: `left` subtitles too many for it, and `cut` ones whose text was too long. @typedef {{ cues: Cue[], left: number, cut: number }} Subtitles */

const MOST_BYTES = 5_000_000;
/** Of a film of ten hours with a subtitle every other second there are fewer. */
export const MOST_CUES = 20_000;
/** Of a subtitle; two lines on the screen have some eighty. */
export const MOST_LETTERS = 1_000;
const TIME = /^(?:(\d{1,4}):)?([0-5]?\d):([0-5]?\d)[.,](\d{1,3})$/;
/** Entities that WebVTT knows. @type {Record<string, string>} */
const ENTITIES = { '&amp;': '&', '&lt;': '<', '&gt;': '>', '&nbsp;': ' ', '&lrm;': '', '&rlm;': '' };

/** @param {{ name: string }} file */
export function isSubtitles({ name }) {
  return /\.(srt|vtt)$/i.test(name);
}

/**
 * @param {Blob & { name: string }} file
 * @returns {Promise<Subtitles>} rejects with `invalid-subtitles`
 */
export async function readSubtitles(file) {
  if (file.size > MOST_BYTES) throw invalid(strings.subtitleErrors.large);
  const bytes = new Uint8Array(await file.arrayBuffer());
  const wide = (bytes[0] === 0xff && bytes[1] === 0xfe) ? 'utf-16le' : (bytes[0] === 0xfe && bytes[1] === 0xff) ? 'utf-16be' : 'utf-8';
  let text;
  try {
    text = new TextDecoder(wide, { fatal: true }).decode(bytes);
  } catch {
    throw invalid(strings.subtitleErrors.binary);
  }
  if (text.includes('\0')) throw invalid(strings.subtitleErrors.binary);
  return parseSubtitles(text, /\.vtt$/i.test(file.name));
}

/**
 * Reads each letter a bounded number of times, whatever the text is.
 * @param {string} file its text
 * @param {boolean} vtt
 * @returns {Subtitles} in the order of their starts
 */
export function parseSubtitles(file, vtt) {
  const lines = file.replace(/^\uFEFF/, '').split(/\r\n|\r|\n/);
  if (vtt && !/^WEBVTT([ \t]|$)/.test(lines[0])) throw invalid(strings.subtitleErrors.header);
  /** @type {Cue[]} */
  const cues = [];
  let [left, cut] = [0, 0];
  // What follows the header up to an empty line belongs to it.
  let at = vtt ? endOfBlock(lines, 1) : 0;
  while (at < lines.length) {
    if (isEmpty(lines[at])) {
      at += 1;
      continue;
    }
    const from = at;
    at = endOfBlock(lines, from);
    if (vtt && /^(NOTE|STYLE|REGION)\b/.test(lines[from])) continue;
    const cue = cueOf(lines, from, at);
    if (cue.text === '') continue;
    if (cues.length === MOST_CUES) {
      left += 1;
      continue;
    }
    const text = firstLetters(cue.text);
    if (text !== cue.text) cut += 1;
    cues.push({ ...cue, text });
  }
  if (cues.length === 0) throw invalid(strings.subtitleErrors.empty);
  return { cues: cues.sort((a, b) => a.start - b.start), left, cut };
}

/** @param {string} line */
function isEmpty(line) {
  return line.trim() === '';
}

/** @param {string[]} lines @param {number} from */
function endOfBlock(lines, from) {
  let end = from;
  while (end < lines.length && !isEmpty(lines[end])) end += 1;
  return end;
}

/**
 * @param {string[]} lines
 * @param {number} from
 * @param {number} end
 * @returns {Cue}
 */
function cueOf(lines, from, end) {
  // A number or a name may stand before the times.
  const at = lines[from].includes('-->') ? from : from + 1;
  const line = lines[at] ?? '';
  if (at >= end || !line.includes('-->')) throw invalid(strings.subtitleErrors.stray(from + 1, shortened(lines[from])));
  const [first, last] = line.split('-->', 2).map((part) => seconds(part.trim().split(/\s/, 1)[0]));
  if (first === null || last === null) throw invalid(strings.subtitleErrors.time(at + 1, shortened(line)));
  if (last < first) throw invalid(strings.subtitleErrors.order(at + 1));
  return { start: first, end: last, text: plain(lines.slice(at + 1, end)) };
}

/** @param {string} time @returns {number | null} */
function seconds(time) {
  const parts = TIME.exec(time);
  if (!parts) return null;
  const [, hours = '0', minutes, rest, thousandths] = parts;
  return Number(hours) * 3600 + Number(minutes) * 60 + Number(rest) + Number(thousandths.padEnd(3, '0')) / 1000;
}

/** @param {string[]} lines @returns {string} without tags, places and entities */
function plain(lines) {
  const text = lines.map((line) => without(without(line, '<', '>'), '{\\', '}').trim()).filter(Boolean).join(' ');
  return text.replace(/&\w+;/g, (entity) => ENTITIES[entity] ?? entity).replace(/\s+/g, ' ').trim();
}

/**
 * Not by a pattern such as `<[^>]*>`: that looks for the end from each beginning anew, also where there is none.
 * @param {string} line
 * @param {string} open
 * @param {string} close
 * @returns {string} without what stands between these; what is not closed stays
 */
function without(line, open, close) {
  let kept = '';
  let from = 0;
  for (;;) {
    const start = line.indexOf(open, from);
    const end = start < 0 ? -1 : line.indexOf(close, start + open.length);
    if (end < 0) return kept + line.slice(from);
    kept += line.slice(from, start);
    from = end + close.length;
  }
}

/** @param {string} text @returns {string} as much of it as a subtitle may have */
function firstLetters(text) {
  if (text.length <= MOST_LETTERS) return text;
  // A letter has two units at most; a half that this leaves at the end is beyond those taken.
  return Array.from(text.slice(0, 2 * MOST_LETTERS)).slice(0, MOST_LETTERS).join('').trim();
}

/** @param {string} line */
function shortened(line) {
  const letters = Array.from(line.trim().slice(0, 82));
  return letters.length > 40 ? `${letters.slice(0, 40).join('')}…` : letters.join('');
}

/** @param {string} why */
function invalid(why) {
  return Object.assign(new Error(why), { code: 'invalid-subtitles' });
}

/**
 * The subtitle that is shown at a time, or the nearest that begins or ends within `slack` seconds of it.
 * @param {readonly Cue[]} cues
 * @param {number} time
 * @param {number} slack
 * @returns {Cue | null}
 */
export function cueAt(cues, time, slack) {
  const away = (/** @type {Cue} */ { start, end }) => Math.max(0, start - time, time - end);
  const nearest = cues.reduce((best, cue) => (away(cue) < away(best) ? cue : best), cues[0]);
  return nearest && away(nearest) <= slack ? nearest : null;
}
