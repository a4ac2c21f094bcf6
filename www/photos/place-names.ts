/**
 * Names of the places where photos were taken, from the GPS data of their files. Only the names are stored, for this
 * visit. The locations are neither saved nor sent. Text has no names if the user turned them off.
 */

import { computed, signal } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';
import type { NameOf } from '../engine/place-table.ts';
import type { PageDocument } from '../engine/types.ts';

export type PlaceNames = ReturnType<typeof createPlaceNames>;

/**
 * @param app `locationOf` returns the part of a file with a location; `load` loads the table of places, once; `wanted`:
 * whether text may name places
 */
export function createPlaceNames({
  locationOf,
  load,
  wanted,
}: {
  locationOf: (file: Blob) => Promise<Uint8Array | null>;
  load: () => Promise<NameOf | null>;
  wanted: ReadonlySignal<boolean>;
}) {
  const none: ReadonlyMap<string, string> = new Map();
  const known = signal(new Map() as ReadonlyMap<string, string>);
  /** The names for text, by photo id. */
  const names = computed(() => (wanted.value ? known.value : none));
  /** Whether names could be turned on. */
  const offered = computed(() => !wanted.value && known.value.size > 0);
  let table: Promise<NameOf | null> | undefined;
  let work: Promise<unknown> = Promise.resolve();

  return { names, offered, begin, settled, marked };

  /** Marks the automatic text of a page that has one of the names. */
  function marked(page: PageDocument): PageDocument {
    const found = [...new Set(names.peek().values())];
    const { words = [] } = page;
    if (found.length === 0 || words.length === 0) return page;
    const isLocated = (text: string) => found.some((name) => text.includes(name));
    return {
      ...page,
      words: words.map((word) => (word.made && isLocated(word.text) ? { ...word, located: true } : word)),
    };
  }

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
