// @ts-check
/**
 * The pictures of panels: asked for once, shared, and kept for a while, so that the previous page is there at once.
 */

import { Priority } from '../engine/queue.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').Geometry} Geometry */
/** @typedef {{ x: number, y: number, width: number, height: number, bitmap: ImageBitmap, page: number, crop: Bounds | null, bounds: Bounds }} Patch `page`: the width of the page it was drawn for; `crop` of the photo in `bounds` of the page */
/** @typedef {import('../engine/documents.js').Bounds} Bounds */
/** @typedef {{ promise: Promise<Patch>, stop: AbortController }} Flight */

/** Pictures kept, in bytes: a dozen pages on a large screen. */
const BUDGET = 96 * 2 ** 20;

/** @param {import('../engine/engine.js').Engine['renderPanel']} render */
export function createPatches(render) {
  /** Oldest first. @type {Map<string, Patch>} */
  const kept = new Map();
  /** @type {Map<string, Flight>} */
  const flights = new Map();
  let bytes = 0;
  /** How long a page of a style took, in ms a pixel. @type {Map<string, number>} */
  const pace = new Map();

  return { signature, cached, get, coarse, keepOnly, expected, dispose };

  /**
   * A cut that is moved leaves the panels that it does not touch as they are: what counts is the shape of the panel
   * and of those that it shares an image with, and how many panels there are, which says how wide lines are.
   * @param {PageDocument} document
   * @param {Geometry} geometry
   * @param {number} index
   * @param {number} width
   * @returns {string} all that the picture depends on
   */
  function signature({ style, page, merges, panels }, geometry, index, width) {
    const group = merges.find((other) => other.includes(index)) ?? [index];
    const { photo, crop } = panels[group[0]];
    const shapes = group.map((i) => geometry.panels[i]);
    return JSON.stringify([style, page, photo, crop, geometry.panels[index], shapes, geometry.panels.filter(({ overlay }) => !overlay).length, width]);
  }

  /** @param {string} key @returns {Patch | null} */
  function cached(key) {
    const patch = kept.get(key);
    if (!patch) return null;
    kept.delete(key);
    kept.set(key, patch);
    return patch;
  }

  /**
   * @param {string} key
   * @param {PageDocument} document
   * @param {Geometry} geometry
   * @param {number} index
   * @param {number} width
   * @returns {Promise<Patch>}
   */
  function get(key, document, geometry, index, width) {
    const before = flights.get(key);
    if (before) return before.promise;
    const stop = new AbortController();
    const start = performance.now();
    const promise = render(document, index, width, { tier: 'work', priority: Priority.PANEL, signal: stop.signal })
      .then((patch) => {
        learn(document, width, performance.now() - start);
        return keep(key, { ...patch, page: width, ...shown(document, geometry, index) });
      })
      .finally(() => flights.delete(key));
    flights.set(key, { promise, stop });
    return promise;
  }

  /**
   * A quick picture at half the size, from the small copy of the photo.
   * @param {PageDocument} document
   * @param {Geometry} geometry
   * @param {number} index
   * @param {number} width
   * @returns {Promise<Patch>}
   */
  async function coarse(document, geometry, index, width) {
    const page = Math.ceil(width / 2);
    const key = `coarse/${index}`;
    return { ...await render(document, index, page, { tier: 'small', priority: Priority.PANEL, key }), page, ...shown(document, geometry, index) };
  }

  /**
   * Cancels the pictures that nobody waits for any more.
   * @param {string[]} wanted
   */
  function keepOnly(wanted) {
    for (const [key, { stop }] of flights) {
      if (!wanted.includes(key)) stop.abort();
    }
  }

  /**
   * The last of a page's panels tells how long the page took: they were all asked for together.
   * @param {PageDocument} document
   * @param {number} width
   * @param {number} ms
   */
  function learn({ style, page }, width, ms) {
    const name = JSON.stringify(style);
    const now = ms / (width * width * page.height / page.width);
    pace.set(name, Math.max(now, (pace.get(name) ?? 0) * 0.8));
  }

  /**
   * @param {PageDocument} document
   * @param {number} width
   * @returns {number} how long the page will likely take, in ms
   */
  function expected({ style, page }, width) {
    return (pace.get(JSON.stringify(style)) ?? 0) * width * width * page.height / page.width;
  }

  /**
   * @param {string} key
   * @param {Patch} patch
   */
  function keep(key, patch) {
    kept.set(key, patch);
    bytes += size(patch);
    for (const [old, { bitmap }] of kept) {
      if (bytes <= BUDGET || old === key) break;
      bytes -= size({ bitmap });
      kept.delete(old);
      // Not closed: the canvas may still show it. The browser frees it when nobody holds it.
    }
    return patch;
  }

  function dispose() {
    for (const { stop } of flights.values()) stop.abort();
    kept.clear();
  }
}

/** @param {{ bitmap: ImageBitmap }} patch */
function size({ bitmap }) {
  return bitmap.width * bitmap.height * 4;
}

/**
 * The part of the photo that a panel's image shows, and where that image is: its own, or that of its group.
 * @param {PageDocument} document
 * @param {Geometry} geometry
 * @param {number} index
 * @returns {{ crop: Bounds | null, bounds: Bounds }}
 */
export function shown({ panels, merges }, geometry, index) {
  const group = merges.find((other) => other.includes(index)) ?? [index];
  const boxes = group.map((i) => geometry.panels[i].bounds);
  const [x, y] = [Math.min(...boxes.map((box) => box.x)), Math.min(...boxes.map((box) => box.y))];
  const width = Math.max(...boxes.map((box) => box.x + box.width)) - x;
  const height = Math.max(...boxes.map((box) => box.y + box.height)) - y;
  return { crop: panels[group[0]].crop, bounds: { x, y, width, height } };
}
