/**
 * The photos in use as shots, in board order, with numbers and metadata. Read-only: an edit in `boards.ts` changes
 * them.
 */

import type { Board, Shot } from '../engine/types.ts';

/** Fields with the text on the pages, until the user writes another. */
export const SPOKEN = ['dialogue', 'caption', 'sound'] as const;
export type Spoken = Readonly<Record<(typeof SPOKEN)[number], string>>;
export const UNSPOKEN: Spoken = Object.freeze({ dialogue: '', caption: '', sound: '' });
/** `said`: the text on the pages. */
export type ShotRow = { id: string; number: string; shot: Shot; said: Spoken };
/** The fields that are text and that every board has, in the order of the list. */
export const FIELDS = ['scene', 'number', 'action', ...SPOKEN, 'notes'] as const;
export type Field = (typeof FIELDS)[number];

/** As in an empty project: `Board::default` in `crates/model/src/shots.rs`. */
export const NO_BOARD: Board = Object.freeze({
  fps: 24,
  columns: [],
  frames: 6,
  aspect: '16:9',
  beside: false,
  ruled: false,
  author: '',
  date: '',
  order: [],
});

/** How frames are counted, and how fast. */
export type Rate = Pick<Board, 'fps' | 'pace'>;

/** Rates by their usual names in video editing. DF is drop-frame timecode, which follows the clock. */
export const RATES: Readonly<Record<string, Rate>> = Object.freeze({
  '23.976': { fps: 24, pace: 'ntsc' },
  '24': { fps: 24 },
  '25': { fps: 25 },
  '29.97 NDF': { fps: 30, pace: 'ntsc' },
  '29.97 DF': { fps: 30, pace: 'drop' },
  '30': { fps: 30 },
});
/** At 29.97 DF, two frame numbers are skipped in each minute except every tenth. */
const DROPPED = 2;
const WHOLE = 10;
export const PER_SHEET = [1, 2, 3, 4, 6, 8, 9, 12] as const;
export const ASPECTS: Readonly<Record<string, number>> = Object.freeze({
  '2.39': 2.39,
  '1.85': 1.85,
  '16:9': 16 / 9,
  '4:3': 4 / 3,
  '1:1': 1,
  '9:16': 9 / 16,
});
/** Default duration of a shot in seconds. */
export const USUAL_SECONDS = 2;

/**
 * Like `ordered` in `crates/model/src/shots.rs`: shots that the user moved have a fixed position. Each other shot follows
 * its automatic predecessor.
 */
export function ordered(order: readonly string[], photos: readonly string[]): string[] {
  const there = new Set(photos);
  const told = new Set(order);
  const all = [...new Set(order.filter((id) => there.has(id)))];
  photos.forEach((id, i) => {
    if (!told.has(id)) all.splice(i === 0 ? 0 : all.indexOf(photos[i - 1]) + 1, 0, id);
  });
  return all;
}

/** Like `numbers` in that file: the number of the shot itself, or a count of shots without a number. */
export function numbered(rows: readonly (Pick<ShotRow, 'id' | 'shot'> & { said?: Spoken })[]): ShotRow[] {
  let counted = 0;
  return rows.map((row) => {
    const own = row.shot.number?.trim();
    if (!own) counted += 1;
    return { said: UNSPOKEN, ...row, number: own || String(counted) };
  });
}

/** @returns the name of a rate */
export function rateName({ fps, pace = 'clock' }: Rate): string {
  const same = (rate: Rate) => rate.fps === fps && (rate.pace ?? 'clock') === pace;
  return Object.entries(RATES).find(([, rate]) => same(rate))?.[0] ?? String(fps);
}

/**
 * Returns a length with units, such as `2 s` or `1 min 4 s 12 f`. A counted second of 23.976 or 29.97 frames per second is
 * longer than a second, so that these rates have time codes: `m:ss:ff`, and `m:ss;ff` at 29.97 DF, as `Rate::timecode` counts in
 * `crates/model/src/timecode.rs`.
 */
export function lengthText(frames: number, { fps, pace }: Rate): string {
  if (!pace || pace === 'clock') {
    const seconds = Math.floor(frames / fps);
    const parts = [
      [Math.floor(seconds / 60), 'min'],
      [seconds % 60, 's'],
      [frames % fps, 'f'],
    ] as const;
    const told = parts.filter(([amount]) => amount > 0).map(([amount, unit]) => `${amount} ${unit}`);
    return told.join(' ') || '0 s';
  }
  const number = pace === 'drop' ? withDropped(frames, fps) : frames;
  const seconds = Math.floor(number / fps);
  const two = (value: number) => String(value).padStart(2, '0');
  const mark = pace === 'drop' ? ';' : ':';
  return `${Math.floor(seconds / 60)}:${two(seconds % 60)}${mark}${two(number % fps)}`;
}

/** The number of a frame, with those before it that are left out. */
function withDropped(frames: number, fps: number): number {
  const ten = fps * 60 * WHOLE - DROPPED * (WHOLE - 1);
  const rest = frames % ten;
  const minutes = Math.floor(Math.max(0, rest - DROPPED) / (fps * 60 - DROPPED));
  return frames + DROPPED * ((WHOLE - 1) * Math.floor(frames / ten) + minutes);
}

/** The frame of a number. */
function withoutDropped(number: number, fps: number): number {
  const minutes = Math.floor(number / (fps * 60));
  return number - DROPPED * (minutes - Math.floor(minutes / WHOLE));
}

/**
 * Reads a typed length. `2` or `2.5` are seconds, `36f` are frames, `2:12` are seconds and frames, `0:02:12` adds
 * minutes, `0:00:02:12` adds hours. `1 min 4 s 12 f` has units. At 29.97 DF, seconds and frames are a timecode.
 * @returns frames; null for an empty text, undefined for an invalid length
 */
export function lengthOf(text: string, { fps, pace }: Rate, most: number): number | null | undefined {
  const plain = text.trim().toLowerCase().replace(',', '.');
  if (plain === '') return null;
  const frames = /^(\d+)\s*f$/.exec(plain);
  const seconds = /^(\d+(?:\.\d+)?)\s*s?$/.exec(plain);
  const units = /^(?:(\d+)\s*min)?\s*(?:(\d+)\s*s)?\s*(?:(\d+)\s*f)?$/.exec(plain);
  const parts = /^\d+(?:[:;]\d+){1,3}$/.test(plain) ? plain.split(/[:;]/).map(Number) : null;
  let count = Number.NaN;
  if (frames) count = Number(frames[1]);
  else if (seconds) count = Math.round((Number(seconds[1]) * fps) / (pace && pace !== 'clock' ? 1.001 : 1));
  else if (parts) {
    const [frame, ...up] = parts.toReversed();
    const number = frame + fps * up.reduce((sum, part, i) => sum + part * 60 ** i, 0);
    count = pace === 'drop' ? withoutDropped(number, fps) : number;
  } else if (units) {
    const [minutes, whole, rest] = units.slice(1).map((part) => Number(part ?? 0));
    count = (60 * minutes + whole) * fps + rest;
  }
  return Number.isFinite(count) && count >= 1 ? Math.min(count, most) : undefined;
}

/** Sets a field of a shot. Empty fields are removed. */
export function withField(shot: Shot, field: string, text: string): Shot {
  const { [field as Field]: _, ...rest } = shot;
  return text ? { ...rest, [field]: text } : rest;
}

/** Sets a custom column of a shot. */
export function withColumn(shot: Shot, column: string, text: string): Shot {
  const { more = {}, ...rest } = shot;
  const { [column]: _, ...others } = more;
  const now = text ? { ...others, [column]: text } : others;
  return Object.keys(now).length > 0 ? { ...rest, more: now } : rest;
}
