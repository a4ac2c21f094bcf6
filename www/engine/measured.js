// @ts-check
/**
 * How long the work of a worker takes, in milliseconds: as measured in Chromium on one thread of an AMD EPYC (2 cores),
 * what is slow of its kind. Not for anyone to see: a worker that takes many times as long hangs (`pace.js`).
 */

import { announcedPixels } from './announced-pixels.js';

/** A million pixels of a photo, decoded, reduced and measured: JPEG 20, TIFF and WebP 60. */
const PHOTO = 60;
/** What the browser decodes says its size in ways that are not read here: a large one. */
const FOREIGN_PIXELS = 25_000_000;
/** A million pixels through a block: 5 to 50. */
const BLOCK = 50;
/** Of a designed style, of which only the name is known. */
const BLOCKS = 8;
/** A million pixels of a PNG file. */
const PNG = 100;
/** A million pixels of a JPEG or WebP file, or of pages put together. */
const FILE = 60;
/** A million pixels of a page on which a word is drawn. */
const WORD = 20;
/** What costs the same whatever the size. */
const CALL = 20;

/** A look of a net, and a look at parts of a photo. */
export const LOOKS = { faces: 40, closer: 600, objects: 160, judge: 110 };

const millions = (/** @type {number} */ pixels) => pixels / 1e6;

/** @param {Uint8Array} bytes of its file @param {string | null} foreign what the browser decodes */
export const photoMs = (bytes, foreign) => CALL + PHOTO * millions(foreign ? FOREIGN_PIXELS : announcedPixels(bytes));

/** A frame of a film, which is also made a PNG file. @param {number} pixels */
export const frameMs = (pixels) => CALL + (PHOTO + PNG) * millions(pixels);

/** @param {number} pixels */
export const pngMs = (pixels) => CALL + PNG * millions(pixels);

/** @param {number} pixels */
export const fileMs = (pixels) => CALL + FILE * millions(pixels);

/** @param {number} pixels of the page */
export const wordMs = (pixels) => CALL + WORD * millions(pixels);

/** @param {number} pixels @param {number} blocks */
export const blocksMs = (pixels, blocks) => CALL + BLOCK * blocks * millions(pixels);

/** @param {string} style as JSON @param {number} pixels */
export const styleMs = (style, pixels) => blocksMs(pixels, blocksOf(parsed(style)));

/**
 * A page, or some panels of it.
 * @param {string} document as JSON
 * @param {number} width in pixels
 * @param {number} [panels] how many; all unless told
 */
export function pageMs(document, width, panels) {
  const { page, panels: all, merges, style } = parsed(document) ?? {};
  const tall = page?.height / page?.width;
  // A panel may well be twice as large as the others, a picture across several larger yet.
  const share = panels === undefined || merges?.length > 0 ? 1 : Math.min(1, (2 * panels) / (all?.length || 1));
  return blocksMs(share * width * width * (Number.isFinite(tall) ? tall : 1.5), blocksOf(style));
}

/** @param {string} json @returns {any} what is wrong with it the core tells */
function parsed(json) {
  try {
    return JSON.parse(json);
  } catch {
    return null;
  }
}

/** @param {any} style */
function blocksOf(style) {
  const { background, foreground } = style ?? {};
  return Array.isArray(background) ? background.length + (foreground?.length ?? 0) : BLOCKS;
}
