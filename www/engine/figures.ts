/**
 * Images of a page: one per panel, followed by one for each panel breakout, above all panels. The foregrounds follow:
 * subjects of panels in front of an effect. They are cut out of existing images. The core numbers them so.
 */

import type { PageDocument, Word } from './types.ts';

type Panels = Pick<PageDocument, 'panels' | 'merges'>;
type Page = Panels & Pick<PageDocument, 'words'>;

/** @returns the panels with a breakout; merged panels cannot break out */
export function figuresOf({ panels, merges }: Panels): number[] {
  const out = (index: number) => !merges.some((group) => group.includes(index));
  return panels.flatMap(({ photo, figure }, index) => (figure && photo !== null && out(index) ? [index] : []));
}

/** @returns the index of each image */
export function picturesOf(document: Panels): number[] {
  return Array.from({ length: document.panels.length + figuresOf(document).length }, (_, index) => index);
}

/** @returns the panel of an image */
export function panelOf(document: Page, picture: number): number {
  const count = document.panels.length;
  if (picture < count) return picture;
  const figures = figuresOf(document);
  return figures[picture - count] ?? frontsOf(document)[picture - count - figures.length] ?? 0;
}

/** @returns these images grouped by panel, because the images of a panel are cut out of one drawing */
export function byPanel(document: Page, pictures: readonly number[]): number[][] {
  const panels: Map<number, number[]> = new Map();
  for (const picture of pictures) {
    const panel = panelOf(document, picture);
    panels.set(panel, [...(panels.get(panel) ?? []), picture]);
  }
  return [...panels.values()];
}

/** @returns the panel of an image, and its breakout */
export function drawnWith(document: Page, picture: number): number[] {
  const panel = panelOf(document, picture);
  const figure = figuresOf(document).indexOf(panel);
  return figure < 0 ? [panel] : [panel, document.panels.length + figure];
}

/** @returns the panels whose subjects are in front of an effect, without duplicates */
export function frontsOf({ panels, words = [] }: Partial<Page>): number[] {
  const behind = words.flatMap((word) => standsBehind(word) ?? []);
  return [...new Set(behind)].filter((panel) => panels?.[panel]).sort((a, b) => a - b);
}

/** @returns the panel whose subject is in front of an effect */
export function standsBehind({ kind, behind, panel }: Word): number | null {
  return kind === 'effect' && behind ? (panel ?? null) : null;
}

/** @returns the image index of each foreground */
export function frontPictures(document: Page): number[] {
  const first = picturesOf(document).length;
  return frontsOf(document).map((_, index) => first + index);
}

/**
 * Text items in paint order: items behind a figure come first.
 * @returns their numbers
 */
export function paintOrder(document: Partial<Page>): number[] {
  const fronts = frontsOf(document);
  const words = document.words ?? [];
  const late = (index: number) => !fronts.includes(standsBehind(words[index]) ?? -1);
  return [...words.keys()].sort((a, b) => Number(late(a)) - Number(late(b)));
}
