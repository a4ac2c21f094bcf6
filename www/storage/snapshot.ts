/** The saved part of the session: the document with its history, and the data of all photos that any state needs. */

import { failure } from '../engine/protocol.ts';
import { sheetsOf } from '../engine/sheets.ts';
import type { Fact, Video } from '../document/album.ts';
import type { Editing } from '../document/editing.ts';
import type { Mirror, Shown } from '../document/history.ts';
import type { Project } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Place } from '../document/place.ts';

/** `place` is the storage place of the history in `editing`. */
export type Snapshot = {
  place: Place;
  editing: Editing;
  mirror: Mirror;
  drawn: readonly Project[];
  facts: Fact[];
  videos: Video[];
};

/** @param drawn earlier states */
export function snapshotOf(store: Store, drawn: readonly Project[] = []): Snapshot {
  const editing = store.editing();
  if (!editing) throw failure('core-missing', 'The program is not loaded yet.');
  const needed = factsOf(store, new Set([...editing.photos(), ...photosOf(drawn)]));
  return { place: store.place.peek(), editing, mirror: store.mirror.peek(), drawn, ...needed };
}

/** Returns the facts of photos, and the videos that any of the photos is a frame of. */
export function factsOf(store: Store, ids: ReadonlySet<string>): Pick<Snapshot, 'facts' | 'videos'> {
  const album = store.album.peek();
  const facts = [...ids].flatMap((id) => album.get(id) ?? []);
  const needed = new Set(facts.map(({ id }) => id));
  const videos = [...store.videos.peek().values()].filter(({ ids: frames }) => frames.some((id) => needed.has(id)));
  return { facts, videos };
}

/** @returns the photos of states and of pages shown */
export function photosOf(states: readonly Project[], shown: readonly Shown[] = []): Set<string> {
  const pages = [...states.flatMap(sheetsOf), ...shown].map(({ page }) => page);
  return new Set([
    ...states.flatMap(({ tray }) => tray.map(({ id }) => id)),
    ...pages.flatMap(({ panels }) => panels.flatMap(({ photo }) => photo ?? [])),
  ]);
}
