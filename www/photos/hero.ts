/** The photo that pictures of styles show. */

import { useRef } from 'preact/hooks';
import { useApp } from '../ui/context.ts';

/** The first page's largest photo, for as long as it is in use, so that the pictures stay while pages come and go. */
export function useHero(): string | null {
  const { store, engine } = useApp();
  const hero = useRef(null as string | null);
  const usable = store.photos.value.map(({ id }) => id).filter(engine.hasPhoto);
  if (hero.current === null || !usable.includes(hero.current)) {
    const panels = store.page.value?.panels ?? [];
    const boxes = store.geometry.value?.panels ?? [];
    const area = (i: number) => (boxes[i] ? boxes[i].bounds.width * boxes[i].bounds.height : 0);
    const order = panels.map((_, i) => i).sort((a, b) => area(b) - area(a));
    const shown = order.map((i) => panels[i].photo).find((id) => id !== null && usable.includes(id));
    hero.current = shown ?? usable[0] ?? null;
  }
  return hero.current;
}
