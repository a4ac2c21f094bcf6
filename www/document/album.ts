/**
 * What is known of every photo that was ever added: facts that no edit changes, hence outside of undo.
 */

import type { Likeness, Measures, PhotoMeta, StartTimecode, Subject, Verdict } from '../engine/types.ts';
import type { TrayItem } from './project.ts';

export type Absent = Likeness & { subjects: readonly Subject[] | null; measured: boolean };

/**
 * `meta` and `measures` are null until the photo was read; `credit` names the author of a sample; a frame of a video
 * knows the video's key, its time in seconds and the number of its shot, from 1; `looked`: it was searched for subjects; `absent`: the photo that this one
 * keeps a place for, and what is known of it.
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
};
export type Album = ReadonlyMap<string, Fact>;

/**
 * A video whose frames are photos: `ids`, taken between `start` and `end`. Seconds from its first picture; `duration` and
 * `end` are null until the file was opened. `timecode`: the timecode of its first picture.
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

/** What the planner is told of a photo that is still being read, so that its place on the page is found at once. */
export function unreadMeta(id: string): PhotoMeta {
  return {
    id,
    width: 1500,
    height: 1000,
    fingerprint: unlike(id),
    sharpness: 0,
    taken: null,
    energy: { columns: 1, rows: 1, values: '00' },
    subjects: [],
    focus: null,
  };
}

/** A fingerprint that is far from any other, so that photos that nobody has seen do not count as alike (FNV-1a). */
function unlike(text: string) {
  let hash = 0xcbf29ce484222325n;
  for (const character of text)
    hash = ((hash ^ BigInt(character.charCodeAt(0))) * 0x100000001b3n) & 0xffffffffffffffffn;
  return hash.toString(16).padStart(16, '0');
}

/**
 * Photos in the order they were taken when all of them say so, else in the order given. A part of the album being
 * dated orders nothing: the undated rest would have no place.
 */
export function chronological(facts: readonly Fact[]): Fact[] {
  const when = (fact: Fact) => fact.meta?.taken ?? '';
  if (!facts.every((fact) => when(fact) !== '')) return [...facts];
  return [...facts].sort((a, b) => (when(a) < when(b) ? -1 : when(a) > when(b) ? 1 : 0));
}

/** Frames of a film in the order of their times, in the places that they have together; all else stays where it is. */
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

/** Whether a photo is used: the person's word, else the selection's, else yes. */
export function isUsed(item: TrayItem, verdicts: ReadonlyMap<string, Verdict>): boolean {
  return item.use ?? verdicts.get(item.id)?.kept ?? true;
}
