/** The saved part of the session: the document with its history, and the data of all photos that any state needs. */

import type { Fact, Video } from '../document/album.ts';
import type { History } from '../document/history.ts';
import type { Project } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Place } from '../document/place.ts';

/** `place` is the storage place of this history. */
export type Snapshot = {
  place: Place;
  history: History;
  drawn: readonly Project[];
  facts: Fact[];
  videos: Video[];
};

/** @param drawn earlier states */
export function snapshotOf(store: Store, drawn: readonly Project[] = []): Snapshot {
  const history = store.history.peek();
  const needed = factsOf(store, { ...history, past: [...history.past, ...drawn] });
  return { place: store.place.peek(), history, drawn, ...needed };
}

/** Returns the facts of all photos of a history, and the videos that any of the photos is a frame of. */
export function factsOf(store: Store, history: History): Pick<Snapshot, 'facts' | 'videos'> {
  const album = store.album.peek();
  const facts = [...photosOf(history)].flatMap((id) => album.get(id) ?? []);
  const needed = new Set(facts.map(({ id }) => id));
  const videos = [...store.videos.peek().values()].filter(({ ids }) => ids.some((id) => needed.has(id)));
  return { facts, videos };
}

/** @returns the photos of all times */
export function photosOf({ past, present, future, shown }: History): Set<string> {
  const ids: Set<string> = new Set();
  // Most states have the tray of their neighbour.
  const seen = new Set();
  const states = [present, ...past, ...future];
  const once = (part: unknown, look: () => void) => {
    if (!seen.has(part)) look();
    seen.add(part);
  };
  for (const { tray } of states) once(tray, () => tray.forEach(({ id }) => ids.add(id)));
  const others = states.flatMap((state) => state.others.map(({ page }) => page));
  const pages = [...states.map(({ page }) => page), ...others, ...shown.map(({ page }) => page)];
  for (const page of pages) {
    if (page) once(page, () => page.panels.forEach(({ photo }) => photo !== null && ids.add(photo)));
  }
  return ids;
}
