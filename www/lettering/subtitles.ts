/**
 * Subtitles as SubRip (.srt) and WebVTT (.vtt) files have them. What is malformed is an error that names the line.
 */

import { strings } from '../strings/strings.ts';

/** seconds, and the text without marks */
export type Cue = { start: number; end: number; text: string };

/** What `readSubtitles` gives: `left` subtitles too many for it, and `cut` ones whose text was too long. */
type Subtitles = { cues: Cue[]; left: number; cut: number };

const MOST_BYTES = 5_000_000;
/** Of a film of ten hours with a subtitle every other second there are fewer. */
export const MOST_CUES = 20_000;
/** Of a subtitle; two lines on the screen have some eighty. */
export const MOST_LETTERS = 1_000;
const TIME = /^(?:(\d{1,4}):)?([0-5]?\d):([0-5]?\d)[.,](\d{1,3})$/;
/** Entities that WebVTT knows. */
const ENTITIES: Record<string, string> = {
  '&amp;': '&',
  '&lt;': '<',
  '&gt;': '>',
  '&nbsp;': ' ',
  '&lrm;': '',
  '&rlm;': '',
};

export function isSubtitles({ name }: { name: string }) {
  return /\.(srt|vtt)$/i.test(name);
}

/** @returns rejects with `invalid-subtitles` */
export async function readSubtitles(file: Blob & { name: string }): Promise<Subtitles> {
  if (file.size > MOST_BYTES) throw invalid(strings.subtitleErrors.large);
  const bytes = new Uint8Array(await file.arrayBuffer());
  const wide =
    bytes[0] === 0xff && bytes[1] === 0xfe ? 'utf-16le' : bytes[0] === 0xfe && bytes[1] === 0xff ? 'utf-16be' : 'utf-8';
  let text: string;
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
 * @param file its text
 * @returns in the order of their starts
 */
export function parseSubtitles(file: string, vtt: boolean): Subtitles {
  const lines = file.replace(/^\uFEFF/, '').split(/\r\n|\r|\n/);
  if (vtt && !/^WEBVTT([ \t]|$)/.test(lines[0])) throw invalid(strings.subtitleErrors.header);
  const cues: Cue[] = [];
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

function isEmpty(line: string) {
  return line.trim() === '';
}

function endOfBlock(lines: string[], from: number) {
  let end = from;
  while (end < lines.length && !isEmpty(lines[end])) end += 1;
  return end;
}

function cueOf(lines: string[], from: number, end: number): Cue {
  // A number or a name may stand before the times.
  const at = lines[from].includes('-->') ? from : from + 1;
  const line = lines[at] ?? '';
  if (at >= end || !line.includes('-->')) throw invalid(strings.subtitleErrors.stray(from + 1, shortened(lines[from])));
  const [first, last] = line.split('-->', 2).map((part) => seconds(part.trim().split(/\s/, 1)[0]));
  if (first === null || last === null) throw invalid(strings.subtitleErrors.time(at + 1, shortened(line)));
  if (last < first) throw invalid(strings.subtitleErrors.order(at + 1));
  return { start: first, end: last, text: plain(lines.slice(at + 1, end)) };
}

function seconds(time: string): number | null {
  const parts = TIME.exec(time);
  if (!parts) return null;
  const [, hours = '0', minutes, rest, thousandths] = parts;
  return Number(hours) * 3600 + Number(minutes) * 60 + Number(rest) + Number(thousandths.padEnd(3, '0')) / 1000;
}

/** @returns without tags, places and entities */
function plain(lines: string[]): string {
  const text = lines
    .map((line) => without(without(line, '<', '>'), '{\\', '}').trim())
    .filter(Boolean)
    .join(' ');
  return text
    .replace(/&\w+;/g, (entity) => ENTITIES[entity] ?? entity)
    .replace(/\s+/g, ' ')
    .trim();
}

/**
 * Not by a pattern such as `<[^>]*>`: that looks for the end from each beginning anew, also where there is none.
 * @returns without what stands between these; what is not closed stays
 */
function without(line: string, open: string, close: string): string {
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

/** @returns as much of it as a subtitle may have */
function firstLetters(text: string): string {
  if (text.length <= MOST_LETTERS) return text;
  // A letter has two units at most; a half that this leaves at the end is beyond those taken.
  return Array.from(text.slice(0, 2 * MOST_LETTERS))
    .slice(0, MOST_LETTERS)
    .join('')
    .trim();
}

function shortened(line: string) {
  const letters = Array.from(line.trim().slice(0, 82));
  return letters.length > 40 ? `${letters.slice(0, 40).join('')}…` : letters.join('');
}

function invalid(why: string) {
  return Object.assign(new Error(why), { code: 'invalid-subtitles' });
}

/** The subtitle that is shown at a time, or the nearest that begins or ends within `slack` seconds of it. */
export function cueAt(cues: readonly Cue[], time: number, slack: number): Cue | null {
  const away = ({ start, end }: Cue) => Math.max(0, start - time, time - end);
  const nearest = cues.reduce((best, cue) => (away(cue) < away(best) ? cue : best), cues[0]);
  return nearest && away(nearest) <= slack ? nearest : null;
}
