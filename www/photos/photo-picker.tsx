/** A row of the album's photos for choosing one. */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { PLAIN, thumbnail } from './cover.ts';
import { Thumbnail } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import type { Fact } from '../document/album.ts';

const THUMB = 64;
/** Room next to a photo that the row scrolls to, in CSS pixels. */
const ROOM = 24;

export type Shown = Fact & { meta: NonNullable<Fact['meta']> };

/** @returns the photos that can be drawn, in the order of the album */
export function useDrawnPhotos(): Shown[] {
  const { store, engine } = useApp();
  const masks = store.masks.value;
  return store.facts.value.flatMap((fact) =>
    fact.meta && engine.hasPhoto(fact.id) ? [{ ...fact, meta: { ...fact.meta, mask: masks.get(fact.id) } }] : [],
  );
}

/** @param props `told`: label of the button of a photo with this name */
export function PhotoPicker({
  label,
  facts,
  chosen,
  told,
  onChoose,
}: {
  label: string;
  facts: readonly Shown[];
  chosen: string | null;
  told: (name: string) => string;
  onChoose: (id: string) => void;
}) {
  const { engine } = useApp();
  const row = useRef(null as HTMLDivElement | null);
  // The row scrolls to the chosen photo, and nothing else does.
  useLayoutEffect(() => {
    const photo = row.current?.querySelector('[aria-current]');
    if (!row.current || !photo) return;
    const [all, one] = [row.current, photo].map((element) => element.getBoundingClientRect());
    if (one.left < all.left) row.current.scrollLeft -= all.left - one.left + ROOM;
    else if (one.right > all.right) row.current.scrollLeft += one.right - all.right + ROOM;
  }, [chosen, facts.length]);
  return (
    <div class="photo-picker" role="group" aria-label={label} ref={row}>
      {facts.map(({ id, name, meta }) => (
        <button
          key={id}
          type="button"
          aria-label={told(name)}
          title={name}
          aria-current={id === chosen ? 'true' : undefined}
          onClick={() => onChoose(id)}
        >
          <Thumbnail of={id} draw={(call) => engine.photoFile(id, PLAIN, thumbnail(meta, THUMB), call)} />
        </button>
      ))}
    </div>
  );
}
