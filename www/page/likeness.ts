/** Compares a page with the previous one, to decide whether old pictures can be shown until the new ones are ready. */

import type { Geometry, PageDocument } from '../engine/types.ts';
import type { Sheet } from './painter.ts';

/** @returns whether the panels of both are the same ones, so that their pictures can follow each other */
export function sameShape(a: PageDocument, b: PageDocument): boolean {
  return JSON.stringify([a.layout, a.merges]) === JSON.stringify([b.layout, b.merges]);
}

/** @returns whether there are as many panels as before */
export function onlyMoved({ slots }: Sheet, { panels }: Geometry): boolean {
  return slots.length === panels.length;
}

/** @returns whether only lengths and colours differ, which must follow the pointer at once */
export function sameLook(a: PageDocument, b: PageDocument): boolean {
  const photos = ({ panels }: PageDocument) => panels.map(({ photo }) => photo);
  return JSON.stringify([a.style, photos(a)]) === JSON.stringify([b.style, photos(b)]);
}
