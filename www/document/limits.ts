/** What a project holds at most. The core reads no project beyond it (`src/document/limits.rs`), so none is made here. */

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
});

/** @returns with a sign for each half of a letter that stands alone, which no file and no table can hold */
export function wellFormed(text: string): string {
  // `toWellFormed` is younger than the browsers that run the page.
  return text.replaceAll(/\p{Surrogate}/gu, '\ufffd');
}
