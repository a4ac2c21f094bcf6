/** The kinds of files that pages become, and what the files are called. */

import type { PageDocument } from '../engine/types.ts';

export type Format = 'png' | 'jpeg' | 'webp' | 'pdf' | 'zip' | 'cbz';
/** the pictures of a ZIP or CBZ file */
export type Inside = 'png' | 'jpeg';

export const FORMATS: Record<Format, { ending: string; type: string; lossy: boolean }> = {
  png: { ending: 'png', type: 'image/png', lossy: false },
  jpeg: { ending: 'jpg', type: 'image/jpeg', lossy: true },
  webp: { ending: 'webp', type: 'image/webp', lossy: true },
  pdf: { ending: 'pdf', type: 'application/pdf', lossy: true },
  zip: { ending: 'zip', type: 'application/zip', lossy: false },
  cbz: { ending: 'cbz', type: 'application/vnd.comicbook+zip', lossy: false },
};

export const OF_ONE: readonly Format[] = ['png', 'jpeg', 'webp', 'pdf'];
export const OF_MANY: readonly Format[] = ['pdf', 'zip', 'cbz'];

export function isArchive(format: Format) {
  return format === 'zip' || format === 'cbz';
}

/** @returns the name of the file */
export function fileName(pages: readonly PageDocument[], format: Format): string {
  const { ending } = FORMATS[format];
  if (pages.length > 1) return `inkpanel-${pages.length}-pages.${ending}`;
  const [{ layout, style, seed }] = pages;
  return `inkpanel-${nameOf(layout)}-${nameOf(style)}-${seed}.${ending}`;
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

/** @param index from 0 */
export function panelName(page: PageDocument, index: number) {
  return fileName([page], 'png').replace(/\.png$/, `-panel-${index + 1}.png`);
}

function nameOf(part: string | { id?: string }) {
  return typeof part === 'string' ? part : (part.id ?? 'own');
}
