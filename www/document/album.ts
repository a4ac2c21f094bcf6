/**
 * The album: measurements of every photo that was ever added. Edits do not change them, so they are not part of undo.
 */

import type { Likeness, Measures, PhotoMeta, StartTimecode, Subject, Verdict, VerdictReason } from '../engine/types.ts';
import type { TrayItem } from './project.ts';

export type Absent = Likeness & { subjects: readonly Subject[] | null; measured: boolean };

/**
 * Properties of a photo:
 *
 * - `meta` and `measures`: null until the photo was read
 * - `credit`: the author of a sample
 * - `video`, `time` and `shot` of a video frame: the video key, seconds, and the shot number from 1
 * - `looked`: whether subject detection is done
 * - `absent`: the missing photo that this frame represents, and its properties
 * - `size`: the size from the header of the file, for the time until the photo was read
 */
export type Fact = {
  id: string;
  name: string;
  credit?: string;
  meta: PhotoMeta | null;
  measures: Measures | null;
  video?: string;
  time?: number;
  shot?: number;
  looked?: boolean;
  absent?: Absent;
  size?: { width: number; height: number };
};
export type Album = ReadonlyMap<string, Fact>;

/**
 * A video whose frames are photos: `ids`, taken between `start` and `end`. Seconds from its first frame; `duration` and
 * `end` are null until the file was opened. `timecode`: the timecode of its first frame.
 */
export type Video = {
  key: string;
  name: string;
  file: File;
  ids: readonly string[];
  duration: number | null;
  start: number;
  end: number | null;
  timecode?: StartTimecode;
};

/** Preliminary measurements of a photo that is still being read, so that the planner can place it at once. */
export function unreadMeta(id: string, size: Fact['size'] = { width: 1500, height: 1000 }): PhotoMeta {
  return {
    id,
    ...size,
    fingerprint: unlike(id),
    sharpness: 0,
    taken: null,
    energy: { columns: 1, rows: 1, values: '00' },
    subjects: [],
    focus: null,
  };
}

const extended: WeakMap<PhotoMeta, { facts: Partial<PhotoMeta>; meta: PhotoMeta }> = new WeakMap();

/** @returns measurements with more fields; the same object as before if all fields are the same */
export function withFacts(meta: PhotoMeta, facts: Partial<PhotoMeta>): PhotoMeta {
  const fields = Object.keys(facts) as (keyof PhotoMeta)[];
  if (fields.length === 0) return meta;
  const before = extended.get(meta);
  const isSame = before && Object.keys(before.facts).length === fields.length;
  if (isSame && fields.every((field) => before.facts[field] === facts[field])) return before.meta;
  const next = { ...meta, ...facts };
  extended.set(meta, { facts, meta: next });
  return next;
}

/**
 * A fingerprint that is far from all others, so that unread photos do not count as near-duplicates. FNV-1a differs in a
 * few bits between ids such as p1 and p2. The last steps, from MurmurHash3, mix them.
 */
function unlike(text: string) {
  const times = (value: bigint, factor: bigint) => (value * factor) & 0xffffffffffffffffn;
  let hash = 0xcbf29ce484222325n;
  for (const character of text) hash = times(hash ^ BigInt(character.charCodeAt(0)), 0x100000001b3n);
  for (const factor of [0xff51afd7ed558ccdn, 0xc4ceb9fe1a85ec53n]) hash = times(hash ^ (hash >> 33n), factor);
  return (hash ^ (hash >> 33n)).toString(16).padStart(16, '0');
}

/**
 * Sorts photos by capture time if all have one. If not, the given order stays. If only some photos are dated, the
 * undated ones would have no place in the order.
 */
export function chronological(facts: readonly Fact[]): Fact[] {
  const when = (fact: Fact) => fact.meta?.taken ?? '';
  if (!facts.every((fact) => when(fact) !== '')) return [...facts];
  return [...facts].sort((a, b) => (when(a) < when(b) ? -1 : when(a) > when(b) ? 1 : 0));
}

/** Sorts the frames of each video by time, within their positions. Everything else keeps its position. */
export function inFilmOrder<Item extends { id: string }>(items: readonly Item[], album: Album): readonly Item[] {
  const films = new Map<string, { at: number; time: number }[]>();
  items.forEach(({ id }, at) => {
    const { video, time } = album.get(id) ?? {};
    if (video !== undefined && time !== undefined) {
      const frames = films.get(video) ?? [];
      frames.push({ at, time });
      films.set(video, frames);
    }
  });
  const ordered = [...items];
  for (const frames of films.values()) {
    const sorted = [...frames].sort((a, b) => a.time - b.time);
    frames.forEach(({ at }, i) => {
      ordered[at] = items[sorted[i].at];
    });
  }
  return ordered.every((item, i) => item === items[i]) ? items : ordered;
}

export type { Verdict };

/** Whether a photo is used: the user's choice, or the selection. Default: yes. */
export function isUsed(item: TrayItem, verdicts: ReadonlyMap<string, Verdict>): boolean {
  return item.use ?? verdicts.get(item.id)?.kept ?? true;
}

/**
 * Why each photo is used or not. A better page may exchange photos of a group, so this is not always the reason of the
 * selection.
 * @returns no entry if the reason is the user's choice
 */
export function reasonsOf(
  items: readonly TrayItem[],
  album: Album,
  verdicts: ReadonlyMap<string, Verdict>,
): Map<string, VerdictReason> {
  const usedOf = new Map(items.filter(({ use }) => use).map(({ id }) => [verdicts.get(id)?.group, id]));
  const reasons = new Map<string, VerdictReason>();
  for (const item of items) {
    const verdict = verdicts.get(item.id);
    if (!verdict) continue;
    const used = isUsed(item, verdicts);
    const other = used ? undefined : usedOf.get(verdict.group);
    if (other !== undefined) reasons.set(item.id, { code: 'same-as', name: album.get(other)?.name ?? other });
    else if (used === verdict.kept) reasons.set(item.id, verdict.reason);
  }
  return reasons;
}
