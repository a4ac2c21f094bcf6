/** Styles that are for a part of the photo: for its subject, or for what is behind it. */

import type { Style } from '../engine/types.ts';

/** @returns whether what is drawn depends on what is known of the subject */
export function hasParts(style: Style | undefined): boolean {
  if (!style) return false;
  const { background, foreground = [], where } = style;
  return where !== undefined || [...background, ...foreground].some((step) => step.where && !step.bypass);
}
