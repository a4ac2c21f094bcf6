// @ts-check
/**
 * Subtitles as SubRip (.srt) and WebVTT (.vtt) files have them. What is malformed is an error that names the line.
 */

import { strings } from '../strings.js';

/** @typedef {{ start: number, end: number, text: string }} Cue seconds, and the text without marks */

const MOST_BYTES = 5_000_000;
const TIME = /^(?:(\d+):)?([0-5]?\d):([0-5]?\d)[.,](\d{1,3})$/;
/** Entities that WebVTT knows. @type {Record<string, string>} */
const ENTITIES = { '&amp;': '&', '&lt;': '<', '&gt;': '>', '&nbsp;': ' ', '&lrm;': '', '&rlm;': '' };

/** @param {{ name: string }} file */
export function isSubtitles({ name }) {
  return /\.(srt|vtt)$/i.test(name);
}

/**
 * @param {Blob & { name: string }} file
 * @returns {Promise<Cue[]>} rejects with `invalid-subtitles`
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
 * @param {string} text
 * @param {boolean} vtt
 * @returns {Cue[]} in the order of their starts
 */
export function parseSubtitles(text, vtt) {
  const lines = text.replace(/^\uFEFF/, '').split(/\r\n|\r|\n/);
  if (vtt && !/^WEBVTT([ \t]|$)/.test(lines[0])) throw invalid(strings.subtitleErrors.header);
  /** @type {Cue[]} */
  const cues = [];
  let at = vtt ? 1 : 0;
  // What follows the header up to an empty line belongs to it.
  if (vtt) at = endOfBlock(lines, at);
  while (at < lines.length) {
    if (lines[at].trim() === '') {
      at += 1;
      continue;
    }
    const end = endOfBlock(lines, at);
    if (!(vtt && /^(NOTE|STYLE|REGION)\b/.test(lines[at]))) {
      const cue = cueOf(lines, at, end);
      if (cue.text !== '') cues.push(cue);
    }
    at = end;
  }
  if (cues.length === 0) throw invalid(strings.subtitleErrors.empty);
  return cues.sort((a, b) => a.start - b.start);
}

/** @param {string[]} lines @param {number} from */
function endOfBlock(lines, from) {
  const end = lines.findIndex((line, i) => i >= from && line.trim() === '');
  return end < 0 ? lines.length : end;
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
  const [first, last] = line.split('-->').map((part) => seconds(part.trim().split(/\s/)[0]));
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
  const text = lines.map((line) => line.replace(/<[^>]*>/g, '').replace(/\{\\[^}]*\}/g, '').trim()).filter(Boolean).join(' ');
  return text.replace(/&\w+;/g, (entity) => ENTITIES[entity] ?? entity).replace(/\s+/g, ' ').trim();
}

/** @param {string} line */
function shortened(line) {
  const text = line.trim();
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
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
