/**
 * Durations of worker jobs in milliseconds: slow examples, measured in Chromium on one thread of an AMD EPYC (2 cores).
 * They are only for detecting workers that hang (`pace.ts`).
 */

import { announcedPixels } from './announced-pixels.ts';
import type { PageDocument, Style } from './types.ts';

/** A million pixels of a photo, decoded, reduced and measured: JPEG 20, TIFF and WebP 60. */
const PHOTO = 60;
/** A million pixels of a HEIC photo before that, without the browser's decoder: 50. */
const HEIC = 100;
/** Assumed size of photos that the core does not decode, because their headers are not read: a large one. */
const FOREIGN_PIXELS = 25_000_000;
/** A million pixels through a block: 5 to 50. */
const BLOCK = 50;
/** Assumed number of blocks of a built-in style, which is known only by id. */
const BLOCKS = 8;
/** A million pixels of a PNG file. */
const PNG = 100;
/** A million pixels of a JPEG or WebP file, or of pages put together. */
const FILE = 60;
/** A text item on a million pixels of a page. */
const WORD = 20;
/** Constant costs. */
const CALL = 20;

/**
 * Face detection, detection in parts of a photo, object detection, and one slice of subject detection, which may be one
 * large convolution.
 */
export const LOOKS = { faces: 40, closer: 600, objects: 160, judge: 110, mask: 1000 };

const millions = (pixels: number) => pixels / 1e6;

/**
 * @param bytes of its file
 * @param foreign format that the core does not decode
 */
export const photoMs = (bytes: Uint8Array, foreign: string | null) =>
  CALL + (PHOTO + (foreign === 'HEIC' ? HEIC : 0)) * millions(foreign ? FOREIGN_PIXELS : announcedPixels(bytes));

/** A video frame, including its PNG file. */
export const frameMs = (pixels: number) => CALL + (PHOTO + PNG) * millions(pixels);

export const pngMs = (pixels: number) => CALL + PNG * millions(pixels);

export const fileMs = (pixels: number) => CALL + FILE * millions(pixels);

/** @param pixels of the page */
export const wordMs = (pixels: number) => CALL + WORD * millions(pixels);

export const blocksMs = (pixels: number, blocks: number) => CALL + BLOCK * blocks * millions(pixels);

/** @param style as JSON */
export const styleMs = (style: string, pixels: number) => blocksMs(pixels, blocksOf(parsed(style)));

/**
 * A page, or some of its panels.
 * @param document as JSON
 * @param width in pixels
 * @param panels number of panels; default: all
 */
export function pageMs(document: string, width: number, panels?: number) {
  const { page, panels: all, merges = [], style } = (parsed(document) ?? {}) as Partial<PageDocument>;
  const tall = page ? page.height / page.width : Number.NaN;
  // A panel may well be twice as large as the others, a picture across several larger yet.
  const share = panels === undefined || merges.length > 0 ? 1 : Math.min(1, (2 * panels) / (all?.length || 1));
  return blocksMs(share * width * width * (Number.isFinite(tall) ? tall : 1.5), blocksOf(style));
}

/** @returns the value; null for invalid JSON, which the core reports */
function parsed(json: string): unknown {
  try {
    return JSON.parse(json);
  } catch {
    return null;
  }
}

function blocksOf(style: unknown) {
  const { background, foreground } = (style ?? {}) as Partial<Style>;
  return Array.isArray(background) ? background.length + (foreground?.length ?? 0) : BLOCKS;
}
