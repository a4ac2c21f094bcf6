/**
 * The journal: edits that are not in the database yet, written immediately. An edit right before the tab closes is not
 * lost. Each project has one entry in local storage: the difference between its history and the last written one,
 * identified by its stamp. During a write, the entry also has the difference to the history being written, because
 * either may be in the database later. An entry without a difference is removed.
 *
 * The journal is untrusted: entries that do not match, or give no valid history, are ignored.
 */

import { VERSION as DOCUMENT } from '../engine/versions.ts';
import type { Editing } from '../document/editing.ts';
import type { KeptHistory } from '../engine/core.ts';
import type { Project } from '../document/project.ts';
import type { History, Shown } from '../document/history.ts';

type Box = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;
/** A history that is in the database, or may be. */
export type Base = { stamp: string; history: History };
/** Photos that are not in the database: their ids and names. */
type Names = readonly (readonly [string, string])[];
type Told = { history: History; photos: Names };
/** Runs of list items: start and length. */
type Runs = [number, number][];
/**
 * States by number: states of the base count from 0, `past`, `present` and `future` in sequence; states in `states`
 * count from -1 down. `shown` likewise, with `pages`. A state tells the fields that differ from the base's present.
 */
type Patch = {
  states: Partial<Project>[];
  past: Runs;
  present: number;
  future: Runs;
  pages: (Omit<Shown, 'page'> & { page: unknown })[];
  shown: Runs;
};
/** The entry of a project. */
type Entry = { version: number; bases: { stamp: string; patch: Patch }[]; photos: [string, string][] };
/** The core's reading of a history. */
type Read = (kept: KeptHistory) => Pick<Editing, 'history' | 'dropped'>;
export type Journal = ReturnType<typeof createJournal>;

const VERSION = 1;
const PREFIX = 'inkpanel.journal.';

/** Maximum length of an entry in characters. Longer ones would slow down editing and fill local storage. */
const MOST = 400_000;
/** Maximum length of a list. */
const MOST_ITEMS = 10_000;

/** `box` may throw if storage is blocked */
export function createJournal({ box, most = MOST }: { box: () => Box; most?: number }) {
  return { note, clear, recall, names, tidy };

  /**
   * @param id of the project
   * @returns whether the entry is complete; an entry that is too large is removed
   */
  function note(
    id: string,
    { bases, history, photos }: { bases: readonly Base[]; history: History; photos: Names },
  ): boolean {
    try {
      const told = bases.map((base) => ({ stamp: base.stamp, patch: patchOf(base.history, history) }));
      const text = JSON.stringify({ version: VERSION, bases: told, photos });
      if (text.length <= most) {
        box().setItem(PREFIX + id, text);
        return true;
      }
    } catch {
      // Storage is blocked or full.
    }
    clear(id);
    return false;
  }

  function clear(id: string) {
    try {
      box().removeItem(PREFIX + id);
    } catch {
      // There is no entry.
    }
  }

  /**
   * @param id of a project
   * @param base the project in the database
   * @param readHistory validates a history
   * @returns its latest state in the app; null without a matching entry
   */
  function recall(id: string, base: Base, readHistory: Read): Told | null {
    try {
      const entry = read(id);
      const fits = entry?.bases.find(({ stamp }) => stamp === base.stamp);
      if (!entry || !fits) return null;
      const history = patched(base.history, fits.patch);
      const found = readHistory({ version: DOCUMENT, history });
      if (found.dropped.length > 0) return null;
      // Equal parts stay the same objects, so that the next entry recognises them.
      return { history: kinOf(found.history(), history as History, base.history), photos: entry.photos };
    } catch {
      return null;
    }
  }

  /**
   * @param id of a project
   * @returns its photos that were not written
   */
  function names(id: string): string[] {
    try {
      return read(id)?.photos.map(([, name]) => name) ?? [];
    } catch {
      return [];
    }
  }

  function read(id: string): Pick<Entry, 'bases' | 'photos'> | null {
    const text = box().getItem(PREFIX + id);
    if (text === null) return null;
    const { version, bases, photos }: Partial<Entry> = JSON.parse(text);
    const good =
      version === VERSION &&
      Array.isArray(bases) &&
      Array.isArray(photos) &&
      photos.length <= MOST_ITEMS &&
      photos.every(
        (photo) =>
          Array.isArray(photo) && photo.length === 2 && photo.every((part) => typeof part === 'string' && part !== ''),
      );
    return good ? { bases, photos } : null;
  }

  /**
   * Removes entries that match no project.
   * @param stampOf of a project in the database
   */
  async function tidy(stampOf: (id: string) => Promise<string | undefined>) {
    try {
      const keys = Array.from({ length: box().length }, (_, i) => box().key(i)).flatMap((key) =>
        key?.startsWith(PREFIX) ? key : [],
      );
      for (const key of keys) {
        const id = key.slice(PREFIX.length);
        const stamp = await stampOf(id);
        if (!read(id)?.bases.some((base) => base?.stamp === stamp)) clear(id);
      }
    } catch {
      // Without access to storage, the entries remain.
    }
  }
}

/** made from it by edits, so that equal parts are the same objects */
export function patchOf(base: History, now: History): Patch {
  const known = new Map([...base.past, base.present, ...base.future].map((state, i) => [state, i]));
  const pages: Map<unknown, number> = new Map();
  const states: Patch['states'] = [];
  const number = (state: Project) => {
    const at = known.get(state);
    if (at !== undefined) return at;
    states.push(differing(state, base.present));
    known.set(state, -states.length);
    if (state.page && state.page !== base.present.page) pages.set(state.page, -states.length);
    return -states.length;
  };
  const past = runsOf(now.past.map(number));
  const present = number(now.present);
  const future = runsOf(now.future.map(number));
  const there = new Map(base.shown.map((entry, i) => [entry, i]));
  const fresh: Patch['pages'] = [];
  const shown = runsOf(
    now.shown.map((entry) => {
      const at = there.get(entry);
      if (at !== undefined) return at;
      // Most are the page of a state that is already included.
      fresh.push({ ...entry, page: pages.get(entry.page) ?? entry.page });
      return -fresh.length;
    }),
  );
  return { states, past, present, future, pages: fresh, shown };
}

function differing(state: Project, base: Project): Partial<Project> {
  return Object.fromEntries(Object.entries(state).filter(([field, value]) => value !== base[field as keyof Project]));
}

/** @returns a history that is yet to be checked */
function patched(base: History, { states, past, present, future, pages, shown }: Patch): unknown {
  const fresh = list(states).map((state) => ({ ...base.present, ...state }));
  const all = [...base.past, base.present, ...base.future];
  const state = (at: number) => pick(at, all, fresh);
  const entries = list(pages).map((entry) => ({
    ...entry,
    page: typeof entry.page === 'number' ? state(entry.page).page : entry.page,
  }));
  return {
    past: numbersOf(past).map(state),
    present: state(present),
    future: numbersOf(future).map(state),
    shown: numbersOf(shown).map((at) => pick(at, base.shown, entries)),
  };
}

/**
 * @param from the input of the reader, made from the base
 * @returns with the states and pages of the base where they are the same
 */
function kinOf(read: History, from: History, base: History): History {
  const known = new Set([...base.past, base.present, ...base.future, ...base.shown]);
  const kin: <T extends Project | Shown>(list: readonly T[], source: readonly T[]) => T[] = (list, source) =>
    list.map((item, i) => (known.has(source[i]) ? source[i] : item));
  const [present] = kin([read.present], [from.present]);
  return {
    past: kin(read.past, from.past),
    present,
    future: kin(read.future, from.future),
    shown: kin(read.shown, from.shown),
  };
}

function pick<T>(at: number, old: readonly T[], fresh: readonly T[]) {
  const found = at >= 0 ? old[at] : fresh[-1 - at];
  if (found === undefined) throw new RangeError('The journal tells of what is not there.');
  return found;
}

function runsOf(numbers: readonly number[]): Runs {
  const runs: Runs = [];
  for (const at of numbers) {
    const last = runs.at(-1);
    if (last && at >= 0 && last[0] >= 0 && last[0] + last[1] === at) last[1] += 1;
    else runs.push([at, 1]);
  }
  return runs;
}

function numbersOf(runs: Runs): number[] {
  const numbers: number[] = [];
  for (const [from, count] of list(runs)) {
    if (!Number.isSafeInteger(from) || !Number.isSafeInteger(count) || count < 1 || count > MOST_ITEMS - numbers.length)
      throw new RangeError('The journal is damaged.');
    for (let i = 0; i < count; i += 1) numbers.push(from + i);
  }
  return numbers;
}

function list<Item>(value: readonly Item[]): readonly Item[] {
  if (!Array.isArray(value) || value.length > MOST_ITEMS) throw new RangeError('The journal is damaged.');
  return value;
}
