/** Styles for a part of the photo: the subject or the background. */

import type { Style } from '../engine/types.ts';

/** @returns whether the drawing depends on the subject mask */
export function hasParts(style: Style | undefined): boolean {
  if (!style) return false;
  const { background, foreground = [], where } = style;
  return where !== undefined || [...background, ...foreground].some((step) => step.where && !step.bypass);
}
