/** The photo for previews of styles. */

import { useRef } from 'preact/hooks';
import { useApp } from '../ui/context.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { PhotoMeta } from '../engine/types.ts';

type Album = { store: Pick<Store, 'photos' | 'page' | 'geometry'>; engine: Pick<Engine, 'hasPhoto'> };

/** Minimum and maximum share of a photo that a face should have. */
const [LEAST_FACE, MOST_FACE] = [0.01, 0.35];
/** Minimum and maximum share of a photo that another subject should have. */
const SUBJECT = [0.12, 0.8];
/** Place of the chroma among the numbers of `facts`, and the chroma below which a photo is gray, 0 to 255. */
const CHROMA = 18;
const LEAST_CHROMA = 6;
/** Minimum clearness of the best face. A single face with 1.5 % of the photo has about this clearness. */
const LEAST_CLEAR = 0.1;

/** The photo of style previews. */
export function useHero(): string | null {
  const app = useApp();
  const hero = useRef(null as string | null);
  hero.current = nextHero(app, hero.current, app.subjects.progress.value !== null);
  return hero.current;
}

/**
 * Returns the photo of style previews after another. A photo stays as long as it is in use, so that previews do not change
 * with pages. It is replaced by a photo with a face or a subject, if it shows neither, and by the clearest face at the end of
 * the detection.
 */
export function nextHero(album: Album, hero: string | null, isDetecting: boolean): string | null {
  const usable = usableIn(album);
  const known = new Map(album.store.photos.value.map((photo) => [photo.id, photo]));
  const rank = (id: string) => rankOf(known.get(id)) + (isDetecting ? 0 : faceIn(known.get(id)));
  const stays = hero !== null && usable.includes(hero) && usable.every((id) => rank(id) <= rank(hero));
  return stays ? hero : heroOf(album);
}

/** Returns 2 for a photo with a clear face, 1 with another subject, 0 for others, and -1 for a gray photo. */
export const rankOf = (photo: PhotoMeta | undefined) =>
  isGray(photo) ? -1 : faceIn(photo) > 0 ? 2 : Number(hasSubject(photo));

/**
 * The photo with the clearest face. Without one, the largest photo of the page that is not among the busiest, if possible with
 * a subject. Gray photos come last, because they hide the effect of a style on colours.
 */
export function heroOf(album: Album): string | null {
  const { page, geometry } = album.store;
  const usable = usableIn(album);
  const panels = page.value?.panels ?? [];
  const boxes = geometry.value?.panels ?? [];
  const area = (i: number) => (boxes[i] ? boxes[i].bounds.width * boxes[i].bounds.height : 0);
  const order = panels.map((_, i) => i).sort((a, b) => area(b) - area(a));
  const onPage = order.flatMap((i) => panels[i].photo ?? []).filter((id) => usable.includes(id));
  const known = new Map(album.store.photos.value.map((photo) => [photo.id, photo]));
  const each = [...new Set([...onPage, ...usable])];
  const coloured = each.filter((id) => !isGray(known.get(id)));
  const all = coloured.length > 0 ? coloured : each;
  const faces = all.filter((id) => faceIn(known.get(id)) > 0);
  if (faces.length > 0) return faces.reduce((a, b) => (faceIn(known.get(b)) > faceIn(known.get(a)) ? b : a));
  const busy = all.map((id) => busyness(known.get(id))).sort((a, b) => b - a);
  const limit = busy[Math.floor(busy.length / 3)] ?? Infinity;
  const calm = all.filter((id) => busyness(known.get(id)) <= limit);
  const hasOne = (id: string) => hasSubject(known.get(id));
  return calm.find(hasOne) ?? all.find(hasOne) ?? calm[0] ?? all[0] ?? null;
}

/** The size and certainty of the best face of a photo; 0 without a clear face of a good size. */
function faceIn(photo: PhotoMeta | undefined): number {
  const faces = (photo?.subjects ?? []).filter(({ label }) => label === 'face');
  const sizes = faces.map(({ width, height, score }) => {
    const size = width * height;
    return size >= LEAST_FACE && size <= MOST_FACE ? Math.sqrt(size) * score : 0;
  });
  // A small picture of a crowd shows no face well.
  const clear = Math.max(0, ...sizes) / Math.sqrt(Math.max(1, faces.length));
  return clear < LEAST_CLEAR ? 0 : clear;
}

/** Whether a subject fills a good part of a photo, such as an animal. */
function hasSubject(photo: PhotoMeta | undefined): boolean {
  return (photo?.subjects ?? []).some(({ width, height, score }) => {
    const size = width * height;
    return size >= SUBJECT[0] && size <= SUBJECT[1] && score >= 0.5;
  });
}

/** Whether a photo has hardly any colour. Photos that were not measured count as coloured. */
function isGray(photo: PhotoMeta | undefined): boolean {
  return Number.parseInt(photo?.facts?.slice(2 * CHROMA, 2 * CHROMA + 2) ?? '', 16) < LEAST_CHROMA;
}

/** How evenly a photo has details everywhere, as foliage and water do. */
function busyness(photo: PhotoMeta | undefined): number {
  const { columns = 0, rows = 0, values = '' } = photo?.energy ?? {};
  let sum = 0;
  for (let i = 0; i < columns * rows; i += 1) sum += Number.parseInt(values.slice(2 * i, 2 * i + 2), 16) || 0;
  return sum / Math.max(1, columns * rows);
}

function usableIn({ store, engine }: Album): string[] {
  return store.photos.value.map(({ id }) => id).filter(engine.hasPhoto);
}
