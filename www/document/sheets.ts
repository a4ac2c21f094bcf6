/**
 * The pages of a storyboard. A project keeps the one that is edited apart from the others, so that all that is done to
 * the page need not know of them; here they are one list, in the order in which they are read.
 */

import type { PageDocument } from '../engine/documents.ts';
import type { Project } from './project.ts';

/** A page of a storyboard: `sheet` names its place through all its versions, `pageId` the version. */
export type Sheet = { page: PageDocument; pageId: number; sheet: number };

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

/**
 * @param sheets one at least
 * @param at the one that is edited from now on
 */
export function withSheets(project: Project, sheets: readonly Sheet[], at: number): Project {
  const { page, pageId, sheet } = sheets[at];
  return { ...project, page, pageId, sheet, at, others: sheets.filter((_, i) => i !== at), settings: page.page };
}

/** @returns the photos on them */
export function photosOn(pages: readonly PageDocument[]): Set<string> {
  return new Set(pages.flatMap(({ panels }) => panels.flatMap(({ photo }) => photo ?? [])));
}

/** @returns with another photo wherever one was; the same pages where it was not */
export function exchangedOn(sheets: readonly Sheet[], id: string, by: string): readonly Sheet[] {
  const swap = (photo: string) => (photo === id ? by : photo);
  return sheets.map((sheet) =>
    !photosOn([sheet.page]).has(id)
      ? sheet
      : {
          ...sheet,
          page: {
            ...sheet.page,
            order: sheet.page.order.map(swap),
            panels: sheet.page.panels.map((use) => (use.photo === id ? { ...use, photo: by } : use)),
          },
        },
  );
}
