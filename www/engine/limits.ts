/**
 * How much of a file that comes in is believed, all in one place: lengths, counts and times beyond which it was not made
 * to be looked at. Of the document inside of a project the core has the limits.
 */

import { MOST } from './bounds.ts';

const KB = 2 ** 10;
const MB = 2 ** 20;

/** Of project files, and of the archive in a page PNG. */
export const ARCHIVE = Object.freeze({
  /** Files in it. Pages that were shown before may need more photos than a project has at a time. */
  entries: 20_000,
  /** Bytes of a name; ours have 80. */
  name: KB,
  /** Bytes of the list of files. */
  directory: 16 * MB,
  /**
   * Bytes that one file may unpack to: it is held whole, and once more where it is decoded. What is stored as it is, as
   * we store it, takes no more than it did before.
   */
  entry: 128 * MB,
  /**
   * Bytes that all files together may unpack to. Photos that another program packs hardly get smaller.
   * @param size of the archive
   */
  unpacked: (size: number) => Math.min(256 * MB + 4 * size, 4096 * MB),
});

/** Of `project.json`, before it is given to the core, which has the limits of what is in it. */
export const TEXT = Object.freeze({
  /** Bytes in a project file: a thousand pages take a fifth. */
  project: MOST.text,
  /** Bytes in a page PNG, which tells all pages of its storyboard. */
  page: MOST.text,
});

export const PNG = Object.freeze({
  /** A page of ten thousand chunks was not made to be looked at. */
  chunks: 100_000,
  /** Bytes of a chunk, by the format. */
  longest: 2 ** 31 - 1,
  /** Texts of others that are looked at before it is taken for a picture like others. */
  texts: 64,
  /** Bytes of a keyword and all else before the text of an `iTXt` chunk. */
  textHead: 512,
});

/** Photos of a project that are read at the same time: enough for the workers, and few enough to be held. */
export const PHOTOS_AT_ONCE = 4;

/** Milliseconds for which a file that is being opened may show no sign of life. */
export const SILENCE = 60_000;

/** Photos of a project file that are not in it, and whose places on pages are kept. */
export const PLACES_FOR_LOST = 100;
