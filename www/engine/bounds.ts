/**
 * What a project holds at most. Written out of `src/document/limits.rs` by `cargo xtask bless`, not by hand: the core reads
 * no project beyond it, so none is made here.
 */

export const MOST = Object.freeze({
  /** Photos of a project. */
  photos: 5_000,
  /** Pages of a storyboard. */
  sheets: 1_000,
  /** Words of a page. */
  words: 200,
  /** Characters of a word. */
  letters: 4_000,
  /** Styles of one's own, favourites, and layouts: of each so many. */
  styles: 1_000,
  /** Blocks of one layer of a style. */
  blocks: 32,
  /** Characters of a name. */
  name: 1_000,
  /** A place of a word, in widths and heights of its panel to either side. */
  away: 10,
  /** Bytes of the text of a project. */
  text: 33_554_432,
  /** Bytes of a file of subtitles. */
  subtitles: 5_000_000,
});

/** What a page may be: pixels of a side, pixels in all, dots an inch. */
export const PAGE = Object.freeze({
  leastSide: 64,
  mostSide: 14_000,
  mostPixels: 72_000_000,
  leastDpi: 36,
  mostDpi: 1_200,
});

/** Bits in which fingerprints of look-alikes may differ: the strictest and the loosest that make sense. */
export const ALIKE = Object.freeze({ strict: 4, loose: 16 });

/** Panels of a first page, and of a page among others where no number is wanted. */
export const USUAL_PANELS = 6;

/** Page sizes that people know, the default first. */
export const PAGE_SIZES = Object.freeze([
  { id: 'a4', width: 2480, height: 3508, dpi: 300 },
  { id: 'a4-landscape', width: 3508, height: 2480, dpi: 300 },
  { id: 'letter', width: 2550, height: 3300, dpi: 300 },
  { id: 'square', width: 2400, height: 2400, dpi: 300 },
  { id: 'wide', width: 3840, height: 2160, dpi: 96 },
  { id: 'story', width: 1440, height: 2560, dpi: 96 },
  { id: 'portrait', width: 2160, height: 2700, dpi: 96 },
  { id: 'webtoon', width: 1600, height: 4000, dpi: 96 },
] as const);
