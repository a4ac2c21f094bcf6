/** Keeps a project within the limits of the core. */

export { MOST } from '../engine/bounds.ts';

/** @returns with a sign for each half of a letter that stands alone, which no file and no table can hold */
export function wellFormed(text: string): string {
  // `toWellFormed` is younger than the browsers that run the page.
  return text.replaceAll(/\p{Surrogate}/gu, '\ufffd');
}
