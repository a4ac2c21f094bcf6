/** Finds the photos of a page in this browser: in the open project, then in all saved projects. */

import { inBlobs } from '../database.ts';
import { hashOf, looksLike } from '../../photos/identity.ts';
import type { Album, Fact } from '../../document/album.ts';
import type { createPhotos } from '../../engine/photos.ts';
import type { Database, PhotoRecord } from '../database.ts';
import type { FilePhoto } from './project-json.ts';

/** `exact`: its file has the same hash. If not, it has a similar fingerprint and the same size. */
type Found = { fact: Fact; record: PhotoRecord | null; exact: boolean };

/** by the ids of the missing photos; each photo is used once */
export async function foundPhotos(
  wanted: readonly FilePhoto[],
  {
    album,
    photos,
    database,
  }: {
    album: Album;
    photos: Pick<ReturnType<typeof createPhotos>, 'has' | 'get'>;
    database: () => Promise<Database>;
  },
): Promise<Map<string, Found>> {
  const here = [...album.values()].filter(({ id, absent }) => !absent && photos.has(id));
  const base = await database().catch(() => null);
  const saved = base ? (await base.getAll('facts').catch(() => [])).map(({ fact }) => fact) : [];
  const known = new Set(here.map(({ id }) => id));
  const all = [...here, ...saved.filter(({ id, absent }) => !absent && !known.has(id))].filter(
    ({ meta }) => meta !== null,
  );

  const found: Map<string, Found> = new Map();
  const used = new Set();
  for (const exact of [true, false]) {
    for (const { id, like } of wanted) {
      if (!like || found.has(id)) continue;
      for (const fact of all) {
        if (used.has(fact.id) || !fact.meta || !looksLike(fact.meta, like)) continue;
        const record = known.has(fact.id)
          ? null
          : ((await base
              ?.get('photos', fact.id)
              .then((kept) => (kept ? inBlobs(kept) : null))
              .catch(() => null)) ?? null);
        const file = known.has(fact.id) ? photos.get(fact.id).file : record?.file;
        if (!file || (exact && (like.hash === '' || (await hashOf(file)) !== like.hash))) continue;
        used.add(fact.id);
        found.set(id, { fact, record, exact });
        break;
      }
    }
  }
  return found;
}
