// @ts-check
/** Reads documents in the place of the core, for tests without it: less strict, and of the same shape. */

import { failure } from '../../engine/protocol.js';
import { EMPTY_PROJECT } from '../project.js';
import { parsedJson } from './testing-json.js';
import { renamed } from './project-json.js';
import { VERSION, damaged } from './versions.js';

/** @typedef {import('../history.js').Shown} Shown */
/** @typedef {import('../project.js').Project} Project */
/** @typedef {import('./project-json.js').FilePhoto} FilePhoto */
/** @typedef {import('./project-json.js').FileVideo} FileVideo */

/** Pixels of a side of a photo, at most. */
const LONGEST_SIDE = 1_000_000;

/** @param {(layout: any, page: any) => { panels: unknown[] }} geometry throws for a layout that there is not */
export function fakeReading(geometry) {
  return { readProject, readHistory };

  /** @param {string} text @param {{ prefix?: string }} [how] */
  function readProject(text, { prefix = '' } = {}) {
    let value;
    try {
      value = parsedJson(text);
    } catch (error) {
      throw error instanceof SyntaxError ? damaged('project.json: is no JSON') : error;
    }
    if (value?.format !== 'inkpanel') throw damaged('project.json: is of another program');
    if (!Array.isArray(value.photos)) throw damaged('photos: is no list');
    const { history } = readHistory({ version: value.version, history: { present: value.history?.present, shown: value.history?.shown } });
    const { present, shown } = history;
    /** @type {[FilePhoto[], FileVideo[]]} */
    const [photos, videos] = [value.photos.map(photoOf), (value.videos ?? []).map(videoOf)];
    const ids = [...photos.map(({ id }) => id), ...videos.map(({ key }) => key)];
    const names = new Map(ids.map((id, i) => [id, prefix === '' ? id : `${prefix}${i}`]));
    return renamed({ format: 'inkpanel', version: VERSION, history: { present, shown }, photos, videos, dropped: [] }, names);
  }

  /** @param {any} kept */
  function readHistory(kept) {
    const version = kept?.version;
    if (!Number.isInteger(version)) throw damaged('version: is missing');
    if (version > VERSION) throw failure('newer-project', `version ${version} is newer than ${VERSION}`);
    const history = checkedHistory(structuredClone(kept.history));
    const { page } = history.present;
    if (page && page.version > 1) throw failure('newer-project', `page version ${page.version} is newer than 1`);
    if (page && !isDrawable(page)) throw damaged('present.page: cannot be drawn');
    return { version, history: { ...history, shown: history.shown.filter((entry) => isDrawable(entry.page)) }, dropped: [] };
  }

  /** @param {any} page */
  function isDrawable(page) {
    const inside = (/** @type {any} */ crop) => !crop || (Object.values(crop).every(Number.isFinite) && crop.x + crop.width <= 1 && crop.y + crop.height <= 1);
    const merged = page.merges.flat();
    try {
      return geometry(page.layout, page.page).panels.length === page.panels.length && page.panels.every((/** @type {any} */ panel) => inside(panel.crop)) &&
        new Set(merged).size === merged.length && merged.every((/** @type {any} */ panel) => panel < page.panels.length);
    } catch {
      return false;
    }
  }
}

/**
 * @param {any} history
 * @returns {import('./database.js').KeptHistory} checked, with all fields
 */
function checkedHistory(history) {
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

/** @param {any} photo @param {number} i @returns {FilePhoto} */
function photoOf(photo, i) {
  const { id, name, path, credit, video, time, type, subjects, measured, rank, like, absent } = photo ?? {};
  if (![id, name, path].every((text) => typeof text === 'string' && text !== '')) throw damaged(`photos[${i}]: has no id, name or path`);
  return {
    id, name, path, type: textOr(type, ''), credit: textOr(credit, undefined), video: textOr(video, undefined),
    time: Number.isFinite(time) ? time : undefined, measured: measured !== false,
    subjects: Array.isArray(subjects) && subjects.every(isSubject) ? subjects : null,
    rank: Number.isSafeInteger(rank) && rank >= 0 ? rank : null, like: isLikeness(like) ? likenessOf(like) : null, absent: absent === true,
  };
}

/** @param {any} like */
function isLikeness(like) {
  const { hash, fingerprint, width, height } = like ?? {};
  const sides = [width, height].every((side) => Number.isSafeInteger(side) && side > 0 && side <= LONGEST_SIDE);
  return sides && /^([0-9a-f]{64})?$/.test(hash) && /^[0-9a-f]{16}$/.test(fingerprint);
}

/** @param {any} like */
function likenessOf({ hash, fingerprint, width, height }) {
  return { hash, fingerprint, width, height };
}

/** @param {any} video @param {number} i @returns {FileVideo} */
function videoOf(video, i) {
  const { key, name, path, ids, duration, start, end, type } = video ?? {};
  const good = [key, name, path].every((text) => typeof text === 'string') && Array.isArray(ids) && ids.every((id) => typeof id === 'string');
  if (!good) throw damaged(`videos[${i}]: has no key, name, path or frames`);
  const time = (/** @type {unknown} */ value) => (typeof value === 'number' && value >= 0 ? value : null);
  return { key, name, path, ids, type: textOr(type, ''), duration: time(duration), start: time(start) ?? 0, end: time(end) };
}

/** @param {any} subject */
function isSubject(subject) {
  const { label, score, x, y, width, height } = subject ?? {};
  return typeof label === 'string' && [score, x, y, width, height].every((value) => typeof value === 'number' && value >= -1 && value <= 2);
}

/** @template T @param {unknown} value @param {T} other @returns {string | T} */
function textOr(value, other) {
  return typeof value === 'string' ? value : other;
}

