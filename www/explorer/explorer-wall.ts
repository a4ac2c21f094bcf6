/**
 * The wall of the explorer: the styles that hang there and their thumbnails. Styles whose image is similar to another
 * one, or almost empty, are rejected. Styles keep their position. New styles are added at the end or after their
 * parent, and only the user sorts the wall.
 */

import { signal } from '@preact/signals';
import { coloursOf } from './colours.ts';
import { harshness } from './damage.ts';
import { colourName } from './naming.ts';
import type { Style } from '../engine/types.ts';
import type { Explored } from '../engine/protocol.ts';
import type { Hue, Lightness } from './colours.ts';
import type { Photo } from './explorer.ts';
import type { Signal } from '@preact/signals';

/**
 * A style on the wall: its simple score from 0 to 1, the novelty of its image (a factor of any score), its kind and its
 * photo. Its colours have a harshness from 0 to 2.
 */
export type Item = {
  style: Style;
  score: number;
  novelty: number;
  look: string;
  hue: Hue;
  lightness: Lightness;
  harsh: number;
  photo: Photo;
};

/**
 * Mean difference of two signatures, in steps of 255, up to which they look the same: in any colours, and with one main
 * colour. A small coloured subject changes the mean little, but its hue.
 */
const [ALIKE, ALIKE_IN_HUE] = [7, 7.5];
/** Maximum number of thumbnails, to limit memory. The oldest are removed, unless they are favourites. */
const MOST = 1200;

/**
 * @param stays whether a style must not be removed
 * @param isDamaged whether a picture of a photo has burnt details or lost faces
 */
export function createWall(
  stays: (id: string) => boolean,
  isDamaged: (photo: string, picture: Explored) => boolean = () => false,
) {
  const items: Signal<readonly Item[]> = signal([]);
  const dropped = signal(0);
  /** The thumbnails, outside of the state, as pixels are. */
  const pictures: Map<string, ImageBitmap> = new Map();
  /** Signatures of different photos are not comparable. */
  const signatures: Map<string, { photo: string; signature: Uint8Array }> = new Map();

  return { items, dropped, pictures, sift, hang, redraw, sort, clear };

  /**
   * @param how `choosy`: rejects similar and damaged images; `most`: maximum number; `waiting`: styles that do not hang
   *   yet
   * @returns the styles that may hang
   */
  function sift(
    photo: Photo,
    styles: readonly Style[],
    explored: readonly Explored[],
    { choosy, most = Infinity, waiting = [] }: { choosy: boolean; most?: number; waiting?: readonly Item[] },
  ): Item[] {
    const fresh: Item[] = [];
    for (const one of explored) {
      const style = styles[one.index];
      const spare = pictures.has(style.id) || fresh.length >= most;
      if (spare || (choosy && unwanted(one, photo))) {
        one.bitmap.close();
        if (!spare) dropped.value += 1;
        continue;
      }
      fresh.push(kept(choosy ? renamed(style, one, [...waiting, ...fresh]) : style, one, photo));
    }
    return fresh;
  }

  /** @param behind inserts after this style (default: at the end) */
  function hang(fresh: readonly Item[], behind?: string) {
    if (fresh.length === 0) return;
    const all = items.peek();
    const at = all.findIndex(({ style }) => style.id === behind) + 1 || all.length;
    const next = [...all.slice(0, at), ...fresh, ...all.slice(at)];
    items.value = next.length > MOST ? thinned(next) : next;
  }

  /** Redraws the wall with another photo, unless images would be similar. */
  function redraw(photo: Photo, styles: readonly Style[], explored: readonly Explored[]) {
    const after = new Map<string, Item | null>();
    for (const one of explored) {
      const style = styles[one.index];
      if (!pictures.has(style.id)) {
        one.bitmap.close();
        continue;
      }
      signatures.delete(style.id);
      if (!stays(style.id) && unwanted(one, photo)) {
        one.bitmap.close();
        forget(style.id);
        after.set(style.id, null);
        dropped.value += 1;
      } else after.set(style.id, kept(style, one, photo));
    }
    items.value = items.peek().flatMap((item) => {
      const now = after.get(item.style.id);
      return now === undefined ? item : (now ?? []);
    });
  }

  function unwanted(one: Explored, photo: Photo): boolean {
    const { fault, signature } = one;
    const alike = () =>
      [...signatures.values()].some((other) => other.photo === photo.id && near(other.signature, signature));
    return fault !== '' || isDamaged(photo.id, one) || alike();
  }

  /** Renames a style after its colour. */
  function renamed(style: Style, { signature }: Explored, fresh: readonly Item[]): Style {
    const { hue, lightness } = coloursOf(signature);
    const names = new Set([...items.peek(), ...fresh].map((item) => item.style.name));
    return { ...style, name: colourName(style.name, hue, lightness, (name) => names.has(name)) };
  }

  function kept(style: Style, { score, novelty, look, signature, bitmap }: Explored, photo: Photo): Item {
    pictures.set(style.id, bitmap);
    signatures.set(style.id, { photo: photo.id, signature });
    return { style, score, novelty, look, ...coloursOf(signature), harsh: harshness(signature, look), photo };
  }

  function forget(id: string) {
    pictures.delete(id);
    signatures.delete(id);
  }

  /** @param points score of an item; the highest comes first */
  function sort(points: (item: Item) => number) {
    items.value = [...items.peek()].sort((a, b) => points(b) - points(a));
  }

  function thinned(all: Item[]) {
    let spare = all.length - MOST;
    return all.filter(({ style: { id } }) => {
      if (spare === 0 || stays(id)) return true;
      spare -= 1;
      forget(id);
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
  const most = ALIKE_IN_HUE * a.length;
  let sum = 0;
  for (let i = 0; i < a.length; i += 1) {
    sum += Math.abs(a[i] - b[i]);
    if (sum > most) return false;
  }
  return sum <= ALIKE * a.length || coloursOf(a).hue === coloursOf(b).hue;
}
