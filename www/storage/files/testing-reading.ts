/** Reads documents in the place of the core, for tests without it: less strict, and of the same shape. */

import { failure } from '../../engine/protocol.ts';
import { EMPTY_PROJECT } from '../../document/project.ts';
import { parsedJson } from './testing-json.ts';
import { renamed } from './project-json.ts';
import { VERSION, damaged } from '../versions.ts';
import type { Shown } from '../../document/history.ts';
import type { Project } from '../../document/project.ts';
import type { KeptHistory } from '../database.ts';
import type { FilePhoto, FileVideo } from './project-json.ts';

/** Pixels of a side of a photo, at most. */
const LONGEST_SIDE = 1_000_000;

/** @param geometry throws for a layout that there is not */
export function fakeReading(geometry: (layout: any, page: any) => { panels: unknown[] }) {
  return { readProject, readHistory };

  function readProject(text: string, { prefix = '' }: { prefix?: string } = {}) {
    let value: any;
    try {
      value = parsedJson(text);
    } catch (error) {
      throw error instanceof SyntaxError ? damaged('project.json: is no JSON') : error;
    }
    if (value?.format !== 'inkpanel') throw damaged('project.json: is of another program');
    if (!Array.isArray(value.photos)) throw damaged('photos: is no list');
    const { history } = readHistory({
      version: value.version,
      history: { present: value.history?.present, shown: value.history?.shown },
    });
    const { present, shown } = history;
    const [photos, videos]: [FilePhoto[], FileVideo[]] = [value.photos.map(photoOf), (value.videos ?? []).map(videoOf)];
    const ids = [...photos.map(({ id }) => id), ...videos.map(({ key }) => key)];
    const names = new Map(ids.map((id, i) => [id, prefix === '' ? id : `${prefix}${i}`]));
    return renamed(
      { format: 'inkpanel', version: VERSION, history: { present, shown }, photos, videos, dropped: [] },
      names,
    );
  }

  function readHistory(kept: any) {
    const version = kept?.version;
    if (!Number.isInteger(version)) throw damaged('version: is missing');
    if (version > VERSION) throw failure('newer-project', `version ${version} is newer than ${VERSION}`);
    const history = checkedHistory(structuredClone(kept.history));
    const { page } = history.present;
    if (page && page.version > 1) throw failure('newer-project', `page version ${page.version} is newer than 1`);
    if (page && !isDrawable(page)) throw damaged('present.page: cannot be drawn');
    return {
      version,
      history: { ...history, shown: history.shown.filter((entry) => isDrawable(entry.page)) },
      dropped: [],
    };
  }

  function isDrawable(page: any) {
    const inside = (crop: any) =>
      !crop || (Object.values(crop).every(Number.isFinite) && crop.x + crop.width <= 1 && crop.y + crop.height <= 1);
    const merged = page.merges.flat();
    try {
      return (
        geometry(page.layout, page.page).panels.length === page.panels.length &&
        page.panels.every((panel: any) => inside(panel.crop)) &&
        new Set(merged).size === merged.length &&
        merged.every((panel: any) => panel < page.panels.length)
      );
    } catch {
      return false;
    }
  }
}

/** @returns checked, with all fields */
function checkedHistory(history: any): KeptHistory {
  if (!isObject(history)) throw damaged('history: is missing');
  const states = (name: 'past' | 'future') =>
    list(history[name] ?? [], name).map((state, i) => checkedProject(state, `${name}[${i}]`));
  const shown = list(history.shown ?? [], 'shown').map((entry, i) => {
    if (!isObject(entry) || !isCount(entry.id)) throw damaged(`shown[${i}]: is no page`);
    checkPage(entry.page, `shown[${i}].page`);
    return entry as unknown as Shown;
  });
  return { past: states('past'), present: checkedProject(history.present, 'present'), future: states('future'), shown };
}

function checkedProject(project: any, where: string): Project {
  if (!isObject(project)) throw damaged(`${where}: is missing`);
  const whole = { ...EMPTY_PROJECT, ...project } as any;
  for (const [field, usual] of Object.entries(EMPTY_PROJECT)) {
    const value = whole[field];
    const fits = Array.isArray(usual) ? Array.isArray(value) : usual === null || typeof value === typeof usual;
    if (!fits || (isObject(usual) && !isObject(value)))
      throw damaged(`${where}.${field}: is no ${Array.isArray(usual) ? 'list' : typeof usual}`);
  }
  if (whole.tray.some((item: any) => !isObject(item) || typeof item.id !== 'string'))
    throw damaged(`${where}.tray: is no list of photos`);
  for (const field of ['mine', 'favourites', 'ownLayouts'] as const) {
    if (whole[field].some((item: any) => !isObject(item) || typeof item.id !== 'string'))
      throw damaged(`${where}.${field}: has one without an id`);
  }
  for (const field of ['pageId', 'sheet', 'at'])
    if (!isCount(whole[field])) throw damaged(`${where}.${field}: is no number`);
  if (whole.page !== null) checkPage(whole.page, `${where}.page`);
  whole.others.forEach((other: any, i: number) => {
    if (!isObject(other) || !isCount(other.pageId) || !isCount(other.sheet))
      throw damaged(`${where}.others[${i}]: is no page`);
    checkPage(other.page, `${where}.others[${i}].page`);
  });
  if (whole.at > whole.others.length || (whole.page === null && whole.others.length > 0))
    throw damaged(`${where}.at: is no place among the pages`);
  return whole;
}

function checkPage(page: any, where: string) {
  const size = isObject(page) && isObject(page.page) ? [page.page.width, page.page.height] : [];
  const good =
    size.length === 2 &&
    size.every((side) => typeof side === 'number' && side > 0) &&
    Array.isArray(page.order) &&
    Array.isArray(page.merges) &&
    Array.isArray(page.panels) &&
    page.panels.every((panel: unknown) => isObject(panel));
  if (!good) throw damaged(`${where}: is no page`);
}

function list(value: unknown, where: string): any[] {
  if (!Array.isArray(value)) throw damaged(`${where}: is no list`);
  return value;
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function isCount(value: unknown) {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}

function photoOf(photo: any, i: number): FilePhoto {
  const { id, name, path, credit, video, time, type, subjects, measured, rank, like, absent } = photo ?? {};
  if (![id, name, path].every((text) => typeof text === 'string' && text !== ''))
    throw damaged(`photos[${i}]: has no id, name or path`);
  return {
    id,
    name,
    path,
    type: textOr(type, ''),
    credit: textOr(credit, undefined),
    video: textOr(video, undefined),
    time: Number.isFinite(time) ? time : undefined,
    measured: measured !== false,
    subjects: Array.isArray(subjects) && subjects.every(isSubject) ? subjects : null,
    rank: Number.isSafeInteger(rank) && rank >= 0 ? rank : null,
    like: isLikeness(like) ? likenessOf(like) : null,
    absent: absent === true,
  };
}

function isLikeness(like: any) {
  const { hash, fingerprint, width, height } = like ?? {};
  const sides = [width, height].every((side) => Number.isSafeInteger(side) && side > 0 && side <= LONGEST_SIDE);
  return sides && /^([0-9a-f]{64})?$/.test(hash) && /^[0-9a-f]{16}$/.test(fingerprint);
}

function likenessOf({ hash, fingerprint, width, height }: any) {
  return { hash, fingerprint, width, height };
}

function videoOf(video: any, i: number): FileVideo {
  const { key, name, path, ids, duration, start, end, type } = video ?? {};
  const good =
    [key, name, path].every((text) => typeof text === 'string') &&
    Array.isArray(ids) &&
    ids.every((id) => typeof id === 'string');
  if (!good) throw damaged(`videos[${i}]: has no key, name, path or frames`);
  const time = (value: unknown) => (typeof value === 'number' && value >= 0 ? value : null);
  return {
    key,
    name,
    path,
    ids,
    type: textOr(type, ''),
    duration: time(duration),
    start: time(start) ?? 0,
    end: time(end),
  };
}

function isSubject(subject: any) {
  const { label, score, x, y, width, height } = subject ?? {};
  return (
    typeof label === 'string' &&
    [score, x, y, width, height].every((value) => typeof value === 'number' && value >= -1 && value <= 2)
  );
}

function textOr<T>(value: unknown, other: T): string | T {
  return typeof value === 'string' ? value : other;
}
