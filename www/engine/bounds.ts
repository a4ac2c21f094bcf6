/**
 * Limits of a project. `cargo xtask bless` generates this file from `crates/model/src/limits.rs`. The core rejects projects that
 * exceed them, so the app never makes such projects.
 */

export const MOST = Object.freeze({
  /** Photos of a project. */
  photos: 5_000,
  /** Pages of a storyboard. */
  sheets: 1_000,
  /** Words of a page. */
  words: 200,
  /** Characters of a word. */
  letters: 10_000,
  /** Maximum number of custom styles, of favourites, and of custom layouts. */
  styles: 1_000,
  /** Blocks of one layer of a style. */
  blocks: 32,
  /** Bytes of the file of a texture. */
  texture: 262_144,
  /** Bytes of the file of a model of painters. */
  painters: 4_194_304,
  /** Characters of a name. */
  name: 1_000,
  /** A place of a word, in widths and heights of its panel to either side. */
  away: 10,
  /** Bytes of the text of a project. */
  text: 33_554_432,
  /** Bytes of a file of subtitles. */
  subtitles: 5_000_000,
  /** Characters of a field of a shot. */
  field: 10_000,
  /** Characters of the number or scene of a shot, and of the name of a column. */
  label: 200,
  /** Characters of the logo of a board as a data URL. */
  logo: 65_536,
  /** Maximum number of custom columns. */
  columns: 12,
  /** Frames of a shot. */
  shotFrames: 2_592_000,
  /** Characters of a script. */
  script: 200_000,
  /** Text items that one edit adds. */
  added: 20_000,
});

/** Limits of a page: pixels per side, total pixels, DPI. */
export const PAGE = Object.freeze({
  leastSide: 64,
  mostSide: 14_000,
  mostPixels: 72_000_000,
  leastDpi: 36,
  mostDpi: 1_200,
});

/** Maximum fingerprint distance of near-duplicates, in bits: default, and range in the app. */
export const DUPLICATE_THRESHOLD = Object.freeze({ default: 10, min: 4, max: 16 });

/** Maximum number of panels of a first page, and default number of later pages. */
export const USUAL_PANELS = 6;

/** Animatics: `foot` is the distance of captions from the lower edge in frame heights, `columns` the numbers per frame in the table. */
export const ANIMATIC = Object.freeze({ foot: 0.05, columns: 15 });

/** Frame sizes of animatics by common name, in pixels. */
export const ANIMATIC_SIZES = Object.freeze([
  { id: '1080p', width: 1920, height: 1080 },
  { id: '720p', width: 1280, height: 720 },
  { id: 'square', width: 1080, height: 1080 },
  { id: 'upright', width: 1080, height: 1920 },
] as const);

/** Named page sizes, the default first; `safe` and `fold`: distance in pixels from the sides, and from the middle. */
export const PAGE_SIZES = Object.freeze([
  {
    id: 'a4',
    purpose: 'paper',
    width: 2480,
    height: 3508,
    dpi: 300,
    safe: [59, 59],
    fold: 0,
  },
  {
    id: 'a4-landscape',
    purpose: 'paper',
    width: 3508,
    height: 2480,
    dpi: 300,
    safe: [59, 59],
    fold: 0,
  },
  {
    id: 'a3',
    purpose: 'paper',
    width: 3508,
    height: 4961,
    dpi: 300,
    safe: [59, 59],
    fold: 0,
  },
  {
    id: 'a5',
    purpose: 'paper',
    width: 1748,
    height: 2480,
    dpi: 300,
    safe: [59, 59],
    fold: 0,
  },
  {
    id: 'a6',
    purpose: 'paper',
    width: 1240,
    height: 1748,
    dpi: 300,
    safe: [47, 47],
    fold: 0,
  },
  {
    id: 'letter',
    purpose: 'paper',
    width: 2550,
    height: 3300,
    dpi: 300,
    safe: [76, 76],
    fold: 0,
  },
  {
    id: 'letter-landscape',
    purpose: 'paper',
    width: 3300,
    height: 2550,
    dpi: 300,
    safe: [76, 76],
    fold: 0,
  },
  {
    id: 'half-letter',
    purpose: 'paper',
    width: 1650,
    height: 2550,
    dpi: 300,
    safe: [76, 76],
    fold: 0,
  },
  {
    id: 'legal',
    purpose: 'paper',
    width: 2550,
    height: 4200,
    dpi: 300,
    safe: [76, 76],
    fold: 0,
  },
  {
    id: 'tabloid',
    purpose: 'paper',
    width: 3300,
    height: 5100,
    dpi: 300,
    safe: [76, 76],
    fold: 0,
  },
  {
    id: 'us-comic',
    purpose: 'book',
    width: 1988,
    height: 3075,
    dpi: 300,
    safe: [76, 76],
    fold: 0,
  },
  {
    id: 'manga-b5',
    purpose: 'book',
    width: 2150,
    height: 3035,
    dpi: 300,
    safe: [71, 71],
    fold: 0,
  },
  {
    id: 'tankobon',
    purpose: 'book',
    width: 1500,
    height: 2150,
    dpi: 300,
    safe: [71, 71],
    fold: 0,
  },
  {
    id: 'square',
    purpose: 'book',
    width: 2400,
    height: 2400,
    dpi: 300,
    safe: [59, 59],
    fold: 0,
  },
  {
    id: 'spread-a4',
    purpose: 'book',
    width: 4961,
    height: 3508,
    dpi: 300,
    safe: [71, 71],
    fold: 118,
  },
  {
    id: 'spread-square',
    purpose: 'book',
    width: 4961,
    height: 2480,
    dpi: 300,
    safe: [71, 71],
    fold: 118,
  },
  {
    id: 'wide',
    purpose: 'screen',
    width: 3840,
    height: 2160,
    dpi: 96,
    safe: [192, 108],
    fold: 0,
  },
  {
    id: 'story',
    purpose: 'screen',
    width: 1440,
    height: 2560,
    dpi: 96,
    safe: [86, 333],
    fold: 0,
  },
  {
    id: 'portrait',
    purpose: 'screen',
    width: 2160,
    height: 2700,
    dpi: 96,
    safe: [108, 135],
    fold: 0,
  },
  {
    id: 'webtoon',
    purpose: 'screen',
    width: 1600,
    height: 4000,
    dpi: 96,
    safe: [80, 0],
    fold: 0,
  },
] as const);
