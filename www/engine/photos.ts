/**
 * The photos of an album as the main thread holds them: the original file and two Blobs of planes each. The browser
 * stores blobs outside of JavaScript memory, and workers read them on demand. It also stores the subject masks, because
 * styles may apply to only the subject.
 */

import { failure } from './protocol.ts';
import type { PhotoHandle } from './protocol.ts';

type Entry = { name: string; file: Blob; work: PhotoHandle; small: PhotoHandle };

export function createPhotos() {
  const entries: Map<string, Entry> = new Map();
  const masks: Map<string, string> = new Map();

  return {
    add: (id: string, entry: Entry) => void entries.set(id, entry),
    has: (id: string) => entries.has(id),
    /** Whether only a draft of the photo is there. */
    isDraft: (id: string) => entries.get(id)?.work.draft === true,
    forget: (id: string) => {
      entries.delete(id);
      masks.delete(id);
    },
    /** @param mask which part of the photo is its subject */
    know: (id: string, mask: string | undefined) => {
      if (mask) masks.set(id, mask);
      else masks.delete(id);
    },
    maskOf: (id: string) => masks.get(id),
    handle,
    get,
    handles,
    names,
  };

  function get(id: string): Entry {
    const entry = entries.get(id);
    if (!entry) throw failure('missing-photo', `The photo ${id} is not in this album.`);
    return entry;
  }

  /** @returns one per photo, without duplicates */
  function handles(ids: (string | null)[], tier: 'small' | 'work'): PhotoHandle[] {
    return [...new Set(ids)].flatMap((id) => (id === null ? [] : handle(id, tier)));
  }

  function handle(id: string, tier: 'small' | 'work'): PhotoHandle {
    const mask = masks.get(id);
    return mask ? { ...get(id)[tier], mask } : get(id)[tier];
  }

  /** @returns the names of the photos, for messages */
  function names(ids: (string | null)[]): string {
    return [...new Set(ids)].flatMap((id) => (id === null ? [] : (entries.get(id)?.name ?? id))).join(', ');
  }
}
