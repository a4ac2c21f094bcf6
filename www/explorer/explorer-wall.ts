/**
 * The wall of the explorer: the styles that hang there and their thumbnails. What looks like another that hangs
 * already, or like nothing, is turned away.
 */

import { signal } from '@preact/signals';
import type { Style } from '../engine/types.ts';
import type { Explored } from '../engine/protocol.ts';
import type { Photo } from './explorer.ts';
import type { Signal } from '@preact/signals';

/**
 * A style that hangs there: its light score from 0 to 1, how new its picture is, which any score is multiplied by, and
 * the photo that it is on.
 */
export type Item = { style: Style; score: number; novelty: number; look: string; photo: Photo };

/** Mean difference of two signatures, in steps of 255, up to which they look the same. */
const ALIKE = 7;
/** More thumbnails than this only take memory; the oldest go, unless they are favourites. */
const MOST = 1200;

/** @param stays whether a style must not go, however many there are */
export function createWall(stays: (id: string) => boolean) {
  const items: Signal<readonly Item[]> = signal([]);
  const dropped = signal(0);
  /** The thumbnails, outside of the state, as pixels are. */
  const pictures: Map<string, ImageBitmap> = new Map();
  const signatures: Map<string, Uint8Array> = new Map();

  return { items, dropped, pictures, hang, clear };

  function hang(photo: Photo, styles: Style[], explored: Explored[], choosy: boolean, ahead: boolean) {
    const fresh: Item[] = [];
    for (const { index, score, novelty, fault, look: kind, signature, bitmap } of explored) {
      const style = styles[index];
      const known = pictures.has(style.id);
      if (known || (choosy && (fault !== '' || [...signatures.values()].some((other) => near(other, signature))))) {
        bitmap.close();
        if (!known) dropped.value += 1;
        continue;
      }
      pictures.set(style.id, bitmap);
      signatures.set(style.id, signature);
      fresh.push({ style, score, novelty, look: kind, photo });
    }
    const all = ahead ? [...fresh, ...items.peek()] : [...items.peek(), ...fresh];
    items.value = all.length > MOST ? thinned(all) : all;
  }

  function thinned(all: Item[]) {
    let spare = all.length - MOST;
    return all.filter(({ style: { id } }) => {
      if (spare === 0 || stays(id)) return true;
      spare -= 1;
      pictures.delete(id);
      signatures.delete(id);
      return false;
    });
  }

  function clear() {
    pictures.clear();
    signatures.clear();
    dropped.value = 0;
    items.value = [];
  }
}

/** @returns whether two pictures of one photo look the same */
export function near(a: Uint8Array, b: Uint8Array): boolean {
  const most = ALIKE * a.length;
  let sum = 0;
  for (let i = 0; i < a.length; i += 1) {
    sum += Math.abs(a[i] - b[i]);
    if (sum > most) return false;
  }
  return true;
}
