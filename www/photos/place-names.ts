/**
 * Names of the places where photos were taken, from the GPS data of their files. Only the names are stored, for this
 * visit. The locations are neither saved nor sent.
 */

import { computed, signal } from '@preact/signals';
import type { NameOf } from '../engine/place-table.ts';

export type PlaceNames = ReturnType<typeof createPlaceNames>;

/** @param app `locationOf` returns the part of a file with a location; `load` loads the table of places, once */
export function createPlaceNames({
  locationOf,
  load,
}: {
  locationOf: (file: Blob) => Promise<Uint8Array | null>;
  load: () => Promise<NameOf | null>;
}) {
  const known = signal(new Map() as ReadonlyMap<string, string>);
  /** By photo id. */
  const names = computed(() => known.value);
  let table: Promise<NameOf | null> | undefined;
  let work: Promise<unknown> = Promise.resolve();

  return { names, begin, settled };

  /** Looks for the places of new photos, one after the other. @param sources their files, with the ids of the photos */
  function begin(sources: readonly { file: File; ids: readonly string[]; video: unknown }[]) {
    work = work.then(() => look(sources)).catch(() => undefined);
  }

  /** @returns resolves when all places are looked up */
  async function settled(): Promise<void> {
    await work;
  }

  async function look(sources: Parameters<typeof begin>[0]) {
    const found: [string, string][] = [];
    for (const { file, ids, video } of sources) {
      const bytes = video ? null : await locationOf(file).catch(() => null);
      if (!bytes) continue;
      table ??= load();
      const name = (await table)?.(bytes);
      if (name) found.push(...ids.map((id): [string, string] => [id, name]));
    }
    if (found.length > 0) known.value = new Map([...known.value, ...found]);
  }
}
