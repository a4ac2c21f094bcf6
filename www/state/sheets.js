// @ts-check
/**
 * The pages of a storyboard. A project keeps the one that is edited apart from the others, so that all that is done to
 * the page need not know of them; here they are one list, in the order in which they are read.
 */

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('./project.js').Project} Project */
/** A page of a storyboard: `sheet` names its place through all its versions, `pageId` the version. @typedef {{ page: PageDocument, pageId: number, sheet: number }} Sheet */

/**
 * @param {Pick<Project, 'page' | 'pageId' | 'sheet' | 'others' | 'at'>} project
 * @returns {readonly Sheet[]} in order, the one that is edited among them; none while there is no page
 */
export function sheetsOf({ page, pageId, sheet, others, at }) {
  if (page === null) return [];
  return [...others.slice(0, at), { page, pageId, sheet }, ...others.slice(at)];
}

/**
 * @param {Project} project
 * @param {readonly Sheet[]} sheets one at least
 * @param {number} at the one that is edited from now on
 * @returns {Project}
 */
export function withSheets(project, sheets, at) {
  const { page, pageId, sheet } = sheets[at];
  return { ...project, page, pageId, sheet, at, others: sheets.filter((_, i) => i !== at), settings: page.page };
}

/**
 * @param {readonly PageDocument[]} pages
 * @returns {Set<string>} the photos on them
 */
export function photosOn(pages) {
  return new Set(pages.flatMap(({ panels }) => panels.flatMap(({ photo }) => photo ?? [])));
}

/**
 * @param {readonly Sheet[]} sheets
 * @param {string} id
 * @param {string} by
 * @returns {readonly Sheet[]} with another photo wherever one was; the same pages where it was not
 */
export function exchangedOn(sheets, id, by) {
  const swap = (/** @type {string} */ photo) => (photo === id ? by : photo);
  return sheets.map((sheet) => (!photosOn([sheet.page]).has(id) ? sheet : {
    ...sheet,
    page: {
      ...sheet.page,
      order: sheet.page.order.map(swap),
      panels: sheet.page.panels.map((use) => (use.photo === id ? { ...use, photo: by } : use)),
    },
  }));
}
