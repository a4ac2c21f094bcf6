/**
 * The pages of a storyboard. A project keeps the one that is edited apart from the others, so that all that is done to
 * the page need not know of them; here they are one list, in the order in which they are read.
 */

import type { PageDocument, Project, Sheet } from './types.ts';

export type { Sheet };

/** @returns in order, the one that is edited among them; none while there is no page */
export function sheetsOf({
  page,
  pageId,
  sheet,
  others,
  at,
}: Pick<Project, 'page' | 'pageId' | 'sheet' | 'others' | 'at'>): readonly Sheet[] {
  if (page === null) return [];
  return [...others.slice(0, at), { page, pageId, sheet }, ...others.slice(at)];
}

/** @returns the photos on them */
export function photosOn(pages: readonly PageDocument[]): Set<string> {
  return new Set(pages.flatMap(({ panels }) => panels.flatMap(({ photo }) => photo ?? [])));
}
