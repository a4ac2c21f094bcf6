// @ts-check
/**
 * The version of what is kept, in the database and in project files, and how to make the newest of an older one. A
 * document that is newer than the program, or damaged, is refused with its reason; fields that the program does not
 * know are kept as they are, and fields that were added since get what an empty project has.
 */

import { failure } from '../../engine/protocol.js';
import { EMPTY_PROJECT } from '../project.js';

/** @typedef {import('../history.js').Shown} Shown */
/** @typedef {import('../project.js').Project} Project */
/** @typedef {import('./database.js').KeptHistory} KeptHistory */

export const VERSION = 1;

/**
 * How to go from a version to the next: `MIGRATIONS[1]` makes version 2 of version 1.
 * @type {Record<number, (kept: any) => any>}
 */
const MIGRATIONS = {};

/**
 * @param {any} kept something with a `version` and a `history`
 * @param {{ version?: number, migrations?: Record<number, (kept: any) => any> }} [to]
 * @returns {any} the same of the newest version
 */
export function migrated(kept, { version = VERSION, migrations = MIGRATIONS } = {}) {
  const from = kept?.version;
  if (!Number.isInteger(from) || from < 1) throw damaged('version: is missing');
  if (from > version) throw failure('newer-project', `version ${from} is newer than ${version}`);
  let now = kept;
  for (let at = from; at < version; at += 1) now = { ...migrations[at](now), version: at + 1 };
  return now;
}

/**
 * @param {any} history
 * @returns {KeptHistory} checked, with all fields
 */
export function checkedHistory(history) {
  if (!isObject(history)) throw damaged('history: is missing');
  const states = (/** @type {'past' | 'future'} */ name) => list(history[name] ?? [], name).map((state, i) => checkedProject(state, `${name}[${i}]`));
  const shown = list(history.shown ?? [], 'shown').map((entry, i) => {
    if (!isObject(entry) || !isCount(entry.id)) throw damaged(`shown[${i}]: is no page`);
    checkPage(entry.page, `shown[${i}].page`);
    return /** @type {Shown} */ (/** @type {unknown} */ (entry));
  });
  return { past: states('past'), present: checkedProject(history.present, 'present'), future: states('future'), shown };
}

/**
 * @param {any} project
 * @param {string} where
 * @returns {Project}
 */
function checkedProject(project, where) {
  if (!isObject(project)) throw damaged(`${where}: is missing`);
  const whole = /** @type {any} */ ({ ...EMPTY_PROJECT, ...project });
  for (const [field, usual] of Object.entries(EMPTY_PROJECT)) {
    const value = whole[field];
    const fits = Array.isArray(usual) ? Array.isArray(value) : usual === null || typeof value === typeof usual;
    if (!fits || (isObject(usual) && !isObject(value))) throw damaged(`${where}.${field}: is no ${Array.isArray(usual) ? 'list' : typeof usual}`);
  }
  if (whole.tray.some((/** @type {any} */ item) => !isObject(item) || typeof item.id !== 'string')) throw damaged(`${where}.tray: is no list of photos`);
  for (const field of /** @type {const} */ (['mine', 'favourites', 'ownLayouts'])) {
    if (whole[field].some((/** @type {any} */ item) => !isObject(item) || typeof item.id !== 'string')) throw damaged(`${where}.${field}: has one without an id`);
  }
  for (const field of ['pageId', 'sheet', 'at']) if (!isCount(whole[field])) throw damaged(`${where}.${field}: is no number`);
  if (whole.page !== null) checkPage(whole.page, `${where}.page`);
  whole.others.forEach((/** @type {any} */ other, /** @type {number} */ i) => {
    if (!isObject(other) || !isCount(other.pageId) || !isCount(other.sheet)) throw damaged(`${where}.others[${i}]: is no page`);
    checkPage(other.page, `${where}.others[${i}].page`);
  });
  if (whole.at > whole.others.length || (whole.page === null && whole.others.length > 0)) throw damaged(`${where}.at: is no place among the pages`);
  return whole;
}

/** @param {any} page @param {string} where */
function checkPage(page, where) {
  const size = isObject(page) && isObject(page.page) ? [page.page.width, page.page.height] : [];
  const good = size.length === 2 && size.every((side) => typeof side === 'number' && side > 0) && Array.isArray(page.order) &&
    Array.isArray(page.merges) && Array.isArray(page.panels) && page.panels.every((/** @type {unknown} */ panel) => isObject(panel));
  if (!good) throw damaged(`${where}: is no page`);
}

/** @param {unknown} value @param {string} where @returns {any[]} */
function list(value, where) {
  if (!Array.isArray(value)) throw damaged(`${where}: is no list`);
  return value;
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
function isObject(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** @param {unknown} value */
function isCount(value) {
  return Number.isSafeInteger(value) && /** @type {number} */ (value) >= 0;
}

/** @param {string} what */
export function damaged(what) {
  return failure('damaged-project', what);
}
