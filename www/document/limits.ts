/** Keeps a project within the limits of the core. */

export { MOST } from '../engine/bounds.ts';

/** with a replacement character for each lone surrogate, which files cannot contain */
export function wellFormed(text: string): string {
  // `toWellFormed` is younger than the browsers that run the page.
  return text.replaceAll(/\p{Surrogate}/gu, '\ufffd');
}
