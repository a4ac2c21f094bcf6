/**
 * The pages of a storyboard. A project stores the current page separately, so edits of the page do not depend on the
 * other pages. Here all pages are one list in reading order.
 */

import type { PageDocument, Project, Sheet } from './types.ts';

export type { Sheet };

/** @returns all pages in order, including the current one; empty without pages */
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
