/** Limits of input files: lengths, counts and times. The core has the limits of documents. */

import { MOST } from './bounds.ts';

const KB = 2 ** 10;
const MB = 2 ** 20;

/** Limits of project files, and of the archive in a page PNG. */
export const ARCHIVE = Object.freeze({
  /** Files in it. Pages that were shown before may need more photos than a project has at a time. */
  entries: 20_000,
  /** Bytes of a name; ours have 80. */
  name: KB,
  /** Bytes of the list of files. */
  directory: 16 * MB,
  /**
   * Maximum unpacked size of one file, in bytes. The file is in memory, and once more during decoding. Uncompressed
   * files in an archive need no additional memory.
   */
  entry: 128 * MB,
  /**
   * Bytes that all files together may unpack to. Photos are already compressed, so other programs hardly reduce their
   * size.
   * @param size of the archive
   */
  unpacked: (size: number) => Math.min(256 * MB + 4 * size, 4096 * MB),
});

/** Limits of `project.json`. The core checks its content. */
export const TEXT = Object.freeze({
  /** Maximum size of the text in a project file, in bytes: five times the size of a thousand pages. */
  project: MOST.text,
  /** Bytes of the text in a page PNG, which contains all pages of its storyboard. */
  page: MOST.text,
});

export const PNG = Object.freeze({
  /** A page file with more chunks is malformed. */
  chunks: 100_000,
  /** Bytes of a chunk, by the format. */
  longest: 2 ** 31 - 1,
  /** Maximum number of other text chunks before the project. Files with more are treated as images. */
  texts: 64,
  /** Bytes of the keyword and the other fields before the text of an `iTXt` chunk. */
  textHead: 512,
});

/** Photos of a project that are read at the same time: enough for the workers, and few enough to be held. */
export const PHOTOS_AT_ONCE = 4;

/** Milliseconds for which a file that is being opened may show no sign of life. */
export const SILENCE = 60_000;

/** Maximum number of missing photos of a project file that keep their places on pages. */
export const PLACES_FOR_LOST = 100;
