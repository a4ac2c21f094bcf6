/**
 * Pictures of a page: one a panel, and behind them one for each panel whose figure steps out of it, which lies over all
 * panels. The core numbers them so.
 */

import type { PageDocument } from './types.ts';

type Panels = Pick<PageDocument, 'panels' | 'merges'>;

/** @returns the panels whose figure is to step out; those that share an image have none */
export function figuresOf({ panels, merges }: Panels): number[] {
  const out = (index: number) => !merges.some((group) => group.includes(index));
  return panels.flatMap(({ photo, figure }, index) => (figure && photo !== null && out(index) ? [index] : []));
}

/** @returns the number of each picture */
export function picturesOf(document: Panels): number[] {
  return Array.from({ length: document.panels.length + figuresOf(document).length }, (_, index) => index);
}

/** @returns the panel that a picture belongs to */
export function panelOf(document: Panels, picture: number): number {
  const count = document.panels.length;
  return picture < count ? picture : (figuresOf(document)[picture - count] ?? 0);
}
