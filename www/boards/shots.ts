/**
 * The photos in use as shots: in the order of the board, each with its number and what is told of it. Only read here; what a
 * person types becomes an edit (`boards.ts`).
 */

import type { Board, Shot } from '../engine/types.ts';

export type ShotRow = { id: string; number: string; shot: Shot };
/** The fields that are text and that every board has, in the order of the list. */
export const FIELDS = ['scene', 'number', 'action', 'dialogue', 'notes'] as const;
export type Field = (typeof FIELDS)[number];

/** As in an empty project: `Board::default` in `src/document/shots.rs`. */
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

export const RATES = [24, 25, 30] as const;
export const PER_SHEET = [1, 2, 3, 4, 6, 8, 9, 12] as const;
export const ASPECTS: Readonly<Record<string, number>> = Object.freeze({
  '2.39': 2.39,
  '1.85': 1.85,
  '16:9': 16 / 9,
  '4:3': 4 / 3,
  '1:1': 1,
  '9:16': 9 / 16,
});
/** How long a shot is that says nothing. */
export const USUAL_SECONDS = 2;

/**
 * As `ordered` in `src/document/shots.rs`: those that a person put somewhere, each of the others behind the one that it
 * follows by itself.
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

/** As `numbers` there: a shot's own, else what is counted of those without. */
export function numbered(rows: readonly { id: string; shot: Shot }[]): ShotRow[] {
  let counted = 0;
  return rows.map(({ id, shot }) => {
    const own = shot.number?.trim();
    if (!own) counted += 1;
    return { id, shot, number: own || String(counted) };
  });
}

/** @returns `m:ss:ff`, such as `0:02:12` */
export function lengthText(frames: number, fps: number): string {
  const seconds = Math.floor(frames / fps);
  const two = (value: number) => String(value).padStart(2, '0');
  return `${Math.floor(seconds / 60)}:${two(seconds % 60)}:${two(frames % fps)}`;
}

/**
 * A length as people write it: `2` or `2.5` are seconds, `36f` are frames, `2:12` are seconds and frames, `0:02:12` has minutes
 * before them, `0:00:02:12` hours.
 * @returns frames; null for nothing, undefined for what is no length
 */
export function lengthOf(text: string, fps: number, most: number): number | null | undefined {
  const plain = text.trim().toLowerCase().replace(',', '.');
  if (plain === '') return null;
  const frames = /^(\d+)\s*f$/.exec(plain);
  const seconds = /^(\d+(?:\.\d+)?)\s*s?$/.exec(plain);
  const parts = /^\d+(?:[:;]\d+){1,3}$/.test(plain) ? plain.split(/[:;]/).map(Number) : null;
  let count = Number.NaN;
  if (frames) count = Number(frames[1]);
  else if (seconds) count = Math.round(Number(seconds[1]) * fps);
  else if (parts) {
    const [frame, ...up] = parts.toReversed();
    count = frame + fps * up.reduce((sum, part, i) => sum + part * 60 ** i, 0);
  }
  return Number.isFinite(count) && count >= 1 ? Math.min(count, most) : undefined;
}

/** A shot with another field; what is empty is not told. */
export function withField(shot: Shot, field: string, text: string): Shot {
  const { [field as Field]: _, ...rest } = shot;
  return text ? { ...rest, [field]: text } : rest;
}

/** The same of a column of one's own. */
export function withColumn(shot: Shot, column: string, text: string): Shot {
  const { more = {}, ...rest } = shot;
  const { [column]: _, ...others } = more;
  const now = text ? { ...others, [column]: text } : others;
  return Object.keys(now).length > 0 ? { ...rest, more: now } : rest;
}
