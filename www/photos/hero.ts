/** The photo for previews of styles. */

import { useRef } from 'preact/hooks';
import { useApp } from '../ui/context.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';

type Album = { store: Pick<Store, 'photos' | 'page' | 'geometry'>; engine: Pick<Engine, 'hasPhoto'> };

/** The page's largest photo. It stays the same as long as it is in use, so that previews do not change with pages. */
export function useHero(): string | null {
  const app = useApp();
  const hero = useRef(null as string | null);
  if (hero.current === null || !usableIn(app).includes(hero.current)) hero.current = heroOf(app);
  return hero.current;
}

/** The largest photo of the current page, or the first of the album. */
export function heroOf(album: Album): string | null {
  const { page, geometry } = album.store;
  const usable = usableIn(album);
  const panels = page.value?.panels ?? [];
  const boxes = geometry.value?.panels ?? [];
  const area = (i: number) => (boxes[i] ? boxes[i].bounds.width * boxes[i].bounds.height : 0);
  const order = panels.map((_, i) => i).sort((a, b) => area(b) - area(a));
  const shown = order.map((i) => panels[i].photo).find((id) => id !== null && usable.includes(id));
  return shown ?? usable[0] ?? null;
}

function usableIn({ store, engine }: Album): string[] {
  return store.photos.value.map(({ id }) => id).filter(engine.hasPhoto);
}
