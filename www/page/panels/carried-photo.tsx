/** A thumbnail under the pointer while a photo is dragged from its panel to another one. */

import { PLAIN, thumbnail } from '../../photos/cover.ts';
import { Bitmap } from '../../ui/bitmap.tsx';
import { useApp } from '../../ui/context.ts';
import { carried } from './panel-gestures.ts';

const SIDE = 96;

export function CarriedPhoto() {
  const { store, engine } = useApp();
  const held = carried.value;
  if (!held || !engine.hasPhoto(held.photo)) return null;
  const size = thumbnail(store.album.peek().get(held.photo)?.meta, SIDE);
  return (
    <div class="carried-photo" aria-hidden="true" style={{ translate: `${held.x}px ${held.y}px` }}>
      <Bitmap of={held.photo} draw={(call) => engine.stylePhoto(held.photo, PLAIN, size, call)} />
    </div>
  );
}
