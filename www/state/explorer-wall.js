// @ts-check
/**
 * The wall of the explorer: the styles that hang there and their thumbnails. What looks like another that hangs
 * already, or like nothing, is turned away.
 */

import { signal } from '@preact/signals';

/** @typedef {import('../engine/documents.js').Style} Style */
/** @typedef {import('../engine/protocol.js').Explored} Explored */
/**
 * A style that hangs there: its light score from 0 to 1, how new its picture is, which any score is multiplied by, and
 * the photo that it is on.
 * @typedef {{ style: Style, score: number, novelty: number, look: string, photo: import('./explorer.js').Photo }} Item
 */

/** Mean difference of two signatures, in steps of 255, up to which they look the same. */
const ALIKE = 7;
/** More thumbnails than this only take memory; the oldest go, unless they are favourites. */
const MOST = 1200;

/** @param {(id: string) => boolean} stays whether a style must not go, however many there are */
export function createWall(stays) {
  /** @type {import('@preact/signals').Signal<readonly Item[]>} */
  const items = signal([]);
  const dropped = signal(0);
  /** The thumbnails, outside of the state, as pixels are. @type {Map<string, ImageBitmap>} */
  const pictures = new Map();
  /** @type {Map<string, Uint8Array>} */
  const signatures = new Map();

  return { items, dropped, pictures, hang, clear };

  /**
   * @param {import('./explorer.js').Photo} photo
   * @param {Style[]} styles
   * @param {Explored[]} explored
   * @param {boolean} choosy
   * @param {boolean} ahead
   */
  function hang(photo, styles, explored, choosy, ahead) {
    /** @type {Item[]} */
    const fresh = [];
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

  /** @param {Item[]} all */
  function thinned(all) {
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

/**
 * @param {Uint8Array} a
 * @param {Uint8Array} b
 * @returns {boolean} whether two pictures of one photo look the same
 */
export function near(a, b) {
  const most = ALIKE * a.length;
  let sum = 0;
  for (let i = 0; i < a.length; i += 1) {
    sum += Math.abs(a[i] - b[i]);
    if (sum > most) return false;
  }
  return true;
}
