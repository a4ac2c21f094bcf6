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
  /** Characters of a name. */
  name: 1_000,
  /** A place of a word, in widths and heights of its panel to either side. */
  away: 10,
  /** Bytes of the text of a project. */
  text: 33_554_432,
  /** Bytes of a file of subtitles. */
  subtitles: 5_000_000,
});
