/** The kinds of files that pages become. */

import { KINDS } from '../motion/kinds.ts';
import type { ListKind } from '../engine/protocol.ts';
import type { Kind as FilmKind } from '../motion/kinds.ts';

export type Format = 'png' | 'jpeg' | 'webp' | 'pdf' | 'html' | 'epub' | 'zip' | 'cbz' | ListKind | FilmKind;
/** Formats of the sheets of the storyboard. */
export type BoardWay = 'boardPdf' | 'boardZip';
/** A choice of the dialog. The file type of a video is a second choice, and a ZIP file follows from several pages. */
export type Way = Exclude<Format, FilmKind | 'zip'> | BoardWay | 'strip' | 'print' | 'animatic' | 'motion' | 'project';
/** the pictures of a ZIP or CBZ file */
export type Inside = 'png' | 'jpeg' | 'webp';

/** Lists of the shots of the album, which hold no pictures. */
export const LISTS: readonly ListKind[] = ['csv', 'edl', 'otio', 'xml'];

export const FORMATS: Record<Format, { ending: string; type: string; lossy: boolean }> = {
  png: { ending: 'png', type: 'image/png', lossy: false },
  jpeg: { ending: 'jpg', type: 'image/jpeg', lossy: true },
  webp: { ending: 'webp', type: 'image/webp', lossy: true },
  pdf: { ending: 'pdf', type: 'application/pdf', lossy: true },
  html: { ending: 'html', type: 'text/html', lossy: true },
  epub: { ending: 'epub', type: 'application/epub+zip', lossy: true },
  zip: { ending: 'zip', type: 'application/zip', lossy: false },
  cbz: { ending: 'cbz', type: 'application/vnd.comicbook+zip', lossy: false },
  csv: { ending: 'csv', type: 'text/csv', lossy: false },
  edl: { ending: 'edl', type: 'text/plain', lossy: false },
  otio: { ending: 'otio', type: 'application/json', lossy: false },
  xml: { ending: 'xml', type: 'application/xml', lossy: false },
  mp4: { ...KINDS.mp4, lossy: true },
  webm: { ...KINDS.webm, lossy: true },
  gif: { ...KINDS.gif, lossy: true },
};

export function isBoard(way: Format | Way): way is BoardWay {
  return way === 'boardPdf' || way === 'boardZip';
}

export function isArchive(format: Format | Way): format is 'zip' | 'cbz' {
  return format === 'zip' || format === 'cbz';
}

export function isFilm(format: Format | Way): format is FilmKind {
  return format in KINDS;
}

export function isList(format: Format | Way): format is ListKind {
  return (LISTS as readonly (Format | Way)[]).includes(format);
}

export function isBook(format: Format | Way): format is 'html' | 'epub' {
  return format === 'html' || format === 'epub';
}

/**
 * @param inside of an archive
 * @param webp whether the browser makes WebP files that are smaller than JPEG
 * @returns the kind of the pictures in a file
 */
export function pictureIn(format: Format, inside: Inside, webp: boolean): 'png' | 'jpeg' | 'webp' {
  if (isArchive(format)) return inside;
  if (isList(format) || isFilm(format)) return 'png';
  if (format === 'html') return webp ? 'webp' : 'jpeg';
  return format === 'pdf' || format === 'epub' ? 'jpeg' : format;
}

/**
 * @param index from 0
 * @param count of all pages
 * @returns the name of a page in an archive, so that the order of names is the order of pages
 */
export function pageName(index: number, count: number, inside: Inside): string {
  const digits = Math.max(2, String(count).length);
  return `page-${String(index + 1).padStart(digits, '0')}.${FORMATS[inside].ending}`;
}
