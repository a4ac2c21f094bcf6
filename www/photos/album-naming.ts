/**
 * Names the project after its photos, until the user gives it a name. `album-name.ts` has the rules. The name changes
 * with the photos.
 */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { albumName, albumTitle, isDates, momentOf } from './album-name.ts';
import { foldersOf } from './folders.ts';
import type { Place } from '../document/place.ts';
import type { ReadonlySignal } from '@preact/signals';
import type { Store } from '../document/store.ts';

/** Characters of a name, as many as the field for it takes. */
const MOST = 80;

/** @param app `located`: the places of photos by their GPS data */
export function createAlbumNaming({
  store,
  located,
}: {
  store: Store;
  located?: ReadonlySignal<ReadonlyMap<string, string>>;
}) {
  /** Origin of the photos of this visit, by id. */
  const files: Map<string, { folders: readonly string[]; file: File; modified?: number }> = new Map();
  /** The automatic name of the project; null if the user named it. */
  let free: { place: Place; name: string } | null = null;

  /** Every plan of a page reads the origins and the moments, so they are computed once per change of the album. */
  const origins = computed(() =>
    store.facts.value.map(({ id, meta, credit, absent }) => ({
      id,
      folders: files.get(id)?.folders ?? [],
      modified: () => modifiedOf(id),
      taken: absent ? null : (meta?.taken ?? null),
      sample: credit !== undefined,
    })),
  );
  /** The time and place of each photo, by id. */
  const moments = computed(() => {
    const now = Date.now();
    const found = origins.value.map((origin) => [origin.id, momentOf(origin, now)] as const);
    // The folder that all photos share is not a place of some.
    const places = new Set(found.map(([, { place }]) => place));
    const named = places.size > 1;
    return new Map(
      found.map(([id, { at, place }]) => [id, { at, place: (named && place) || (located?.value.get(id) ?? '') }]),
    );
  });

  const name = computed(() => store.project.value.name);
  /** Computed once per name, because each shuffle asks for the title. */
  const hasDates = computed(() => isDates(name.value, strings.dates));

  return { automatic, title, moments: () => moments.peek(), begin, settle };

  /** @returns the automatic name of the project; empty without information */
  function automatic(): string {
    return named(albumName);
  }

  /** @returns the title of a page: the project name that the user chose, or the folder or days of the photos */
  function title(): string {
    const now = name.peek();
    const isChosen = now !== '' && !isFree(now) && now !== automatic() && !hasDates.peek();
    return isChosen ? now : named(albumTitle);
  }

  function named(by: typeof albumName): string {
    const name = by(origins.peek(), { samples: strings.sampleAlbum, dates: strings.dates, now: Date.now() });
    return [...name].slice(0, MOST).join('');
  }

  /** Asked once per file. */
  function modifiedOf(id: string): number | null {
    const known = files.get(id);
    return known ? (known.modified ??= known.file.lastModified) : null;
  }

  /** Prepares for new photos. @param sources their files, with the ids of the photos */
  function begin(sources: readonly { file: File; ids: readonly string[] }[]) {
    const { name } = store.project.peek();
    if (!isFree(name)) free = name === '' || name === automatic() ? { place: store.place.peek(), name } : null;
    for (const { file, ids } of sources) for (const id of ids) files.set(id, { folders: foldersOf(file), file });
  }

  /**
   * They are there.
   * @param gesture the step of the undo that they belong to; null for the first, which cannot be undone
   */
  function settle(gesture: string | null) {
    const { name } = store.project.peek();
    if (!isFree(name)) return;
    const next = automatic();
    if (next === '' || next === name) return;
    free = { place: store.place.peek(), name: next };
    store.change({ type: 'rename', name: next, ...(gesture === null ? { silent: true } : { gesture }) });
  }

  function isFree(name: string): boolean {
    return free?.place === store.place.peek() && free.name === name;
  }
}
