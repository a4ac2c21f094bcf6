/** A text item of a page as an image with its position, independent of the page size. */

import type { Engine } from '../engine/engine.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';

/** @param width of the page in the pixels of the box @returns the box in fractions of the page */
export function placeOn({ page }: PageDocument, width: number, { x, y, ...size }: Bounds): Bounds {
  const height = (width * page.height) / page.width;
  return { x: x / width, y: y / height, width: size.width / width, height: size.height / height };
}

/** Renders a text item of a page. @param width of the page, in pixels */
export async function drawnWord(
  engine: Pick<Engine, 'renderWord'>,
  document: PageDocument,
  index: number,
  width: number,
  call?: { signal?: AbortSignal },
): Promise<{ bitmap: ImageBitmap; place: Bounds }> {
  const { bitmap, ...box } = await engine.renderWord(document, index, width, call);
  return { bitmap, place: placeOn(document, width, box) };
}
