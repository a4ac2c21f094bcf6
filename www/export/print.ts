/**
 * Options of a printed file: bleed, marks, imposition, plates. Also detects panels whose photos have a low resolution
 * for print.
 */

import type { Album } from '../document/album.ts';
import type { Bounds, Geometry, Imposition, PageDocument, PdfOptions, Style } from '../engine/types.ts';
import { grown } from '../page/panels/merging.ts';

export type Bleed = 'none' | 'mm3' | 'inch' | 'mm5';
export type Paper = 'none' | 'a4' | 'a3' | 'letter' | 'tabloid';
export type Sheets = 'none' | 'booklet' | 'zine' | 'twoUp' | 'spreads';
/** The user's choices. */
export type Print = { bleed: Bleed; marks: boolean; sheets: Sheets; paper: Paper; plates: boolean };
/** A panel whose photo has a low resolution for its size on paper: index of the panel, and DPI. */
export type Coarse = { panel: number; dpi: number };

export const NO_PRINT: Print = { bleed: 'none', marks: false, sheets: 'none', paper: 'none', plates: false };

/** The first choices for a print shop, which trims the sheet. */
export const USUAL_PRINT: Print = { ...NO_PRINT, bleed: 'mm3', marks: true };

/** Millimetres beyond the edge. */
export const BLEEDS: Record<Bleed, number> = { none: 0, mm3: 3, inch: 25.4 / 8, mm5: 5 };
/** Width and height in millimetres. */
export const PAPERS: Record<Paper, [number, number] | null> = {
  none: null,
  a4: [210, 297],
  a3: [297, 420],
  letter: [215.9, 279.4],
  tabloid: [279.4, 431.8],
};
const IMPOSITIONS: Record<Sheets, Imposition | null> = {
  none: null,
  booklet: 'booklet',
  zine: 'zine',
  twoUp: '2up',
  spreads: 'spreads',
};

/** Resolution in DPI below which a print looks soft at arm's length. */
export const COARSE = 200;
/** The most bleed that the core takes, in page widths. */
const MOST_BLEED = 0.1;
const INCH = 25.4;

/** @returns the page with its bleed */
export function bled(document: PageDocument, bleed: Bleed): PageDocument {
  const { width, dpi } = document.page;
  const by = Math.min(MOST_BLEED, BLEEDS[bleed] / ((width / dpi) * INCH));
  return by > 0 ? { ...document, page: { ...document.page, bleed: by } } : document;
}

/** @returns pages with upscaled low-resolution photos, if requested */
export function enlarged(documents: readonly PageDocument[], enlarge: boolean): readonly PageDocument[] {
  if (!enlarge) return documents;
  return documents.map((document) => ({ ...document, page: { ...document.page, enlarge } }));
}

/** @returns the page without print options, which are not saved with it */
export function kept(document: PageDocument): PageDocument {
  const { enlarge: _, ...page } = document.page;
  return { ...document, page };
}

/** The options that apply to a PDF file. */
export function pdfOptions({ marks, sheets, paper }: Print): PdfOptions {
  return { marks, imposition: IMPOSITIONS[sheets], paper: sheets === 'none' ? null : PAPERS[paper] };
}

/** @returns number of empty pages on the last sheets */
export function blanks(sheets: Sheets, pages: number): number {
  const seats = { none: 1, spreads: 1, twoUp: 2, booklet: 4, zine: 8 }[sheets];
  return (seats - (pages % seats)) % seats;
}

/** Whether all pages use the same inks, so that plates are possible. This holds for pages of one style. */
export function hasPlates(pages: readonly PageDocument[], styles: readonly Style[]): boolean {
  const [style, ...others] = new Set(pages.map((page) => JSON.stringify(page.style)));
  if (style === undefined || others.length > 0) return false;
  const [first] = pages;
  const found = typeof first.style === 'string' ? styles.find(({ id }) => id === first.style) : first.style;
  const steps = [...(found?.background ?? []), ...(found?.foreground ?? [])];
  return !found?.where?.background && steps.some(({ block, bypass, where }) => block === 'plates' && !bypass && !where);
}

/**
 * @param inches width of the page on paper
 * @returns panels below `COARSE`, in their order; merged ones once
 */
export function coarsePanels(page: PageDocument, { panels }: Geometry, album: Album, inches: number): Coarse[] {
  return page.panels.flatMap(({ photo, crop }, panel): Coarse[] => {
    const group = grown([panel], page);
    const meta = album.get(photo ?? '')?.meta;
    if (group[0] !== panel || !meta || album.get(photo ?? '')?.absent) return [];
    const bounds = group.map((i) => panels[i]?.bounds).filter((found) => found !== undefined);
    if (bounds.length === 0) return [];
    const all = bounds.reduce(union);
    const pixels = Math.min(
      ((crop?.width ?? 1) * meta.width) / all.width,
      ((crop?.height ?? 1) * meta.height) / all.height,
    );
    const dpi = Math.round(pixels / inches);
    return dpi < COARSE ? [{ panel, dpi }] : [];
  });
}

function union(a: Bounds, b: Bounds): Bounds {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)];
  return {
    x,
    y,
    width: Math.max(a.x + a.width, b.x + b.width) - x,
    height: Math.max(a.y + a.height, b.y + b.height) - y,
  };
}
