/**
 * A history as data between the core and the app. States share most of their parts. The parts are in tables, and states
 * refer to them by index (see `crates/model/src/kept.rs`). 500 states of one tray cost one tray.
 */

import { failure } from './protocol.ts';
import type {
  Edit,
  History,
  How,
  KeptEdit,
  KeptShown,
  KeptState,
  PageDocument,
  PageSettings,
  Project,
  Sheet,
  Shown,
  Tabled,
  TabledHistory,
  Tables,
} from './types.ts';

type Plain = Record<string, unknown>;
/** A history of a record, not validated. */
export type KeptHistory = { version?: unknown; history?: unknown };

/**
 * Throws `damaged-project` if it is not plain data.
 * @param record a history as objects
 * @returns the bytes of this history for an editor: JSON in UTF-8
 */
export function bytesOf({ version, history }: KeptHistory): Uint8Array<ArrayBuffer> {
  try {
    return encoded({ version, history: interned(history) });
  } catch {
    // A cyclic structure, or a number that is not finite.
    throw failure('damaged-project', 'history: is not plain data');
  }
}

/** @returns a record with tables as bytes for an editor */
export function encoded(record: object): Uint8Array<ArrayBuffer> {
  return new TextEncoder().encode(JSON.stringify(record));
}

/**
 * @param bytes from an editor
 * @returns their JSON, not validated
 */
export function recordIn(bytes: Uint8Array): { version: number; history: TabledHistory } {
  return JSON.parse(new TextDecoder().decode(bytes));
}

/** Fields of a state that are in a table. */
const PARTS: readonly [field: Tabled, table: keyof Tables][] = [
  ['settings', 'settings'],
  ['page', 'pages'],
  ['draft', 'drafts'],
  ['board', 'boards'],
];
/** Lists of a state that are in a table, and the tables of their items. */
const LISTS: readonly [field: Tabled, table: keyof Tables, entries: keyof Tables][] = [
  ['tray', 'trays', 'items'],
  ['others', 'books', 'sheets'],
  ['mine', 'shelves', 'styles'],
  ['favourites', 'shelves', 'styles'],
  ['ownLayouts', 'layoutShelves', 'layouts'],
  ['waiting', 'waits', 'words'],
];
const TABLES: readonly (keyof Tables)[] = [
  'items',
  'trays',
  'pages',
  'sheets',
  'books',
  'styles',
  'shelves',
  'layouts',
  'layoutShelves',
  'settings',
  'drafts',
  'words',
  'waits',
  'boards',
];

/**
 * @param history of a record, not validated
 * @returns with `parts`
 */
export function interned(history: unknown): unknown {
  if (!isObject(history)) return history;
  const tables = new Map(TABLES.map((table) => [table, { parts: [] as unknown[], known: new Map<unknown, number>() }]));

  /**
   * @param told the part in the format of the table
   * @returns its index; other values are returned unchanged and cannot be confused with an index
   */
  function named(table: keyof Tables, value: unknown, told: (value: unknown) => unknown = (same) => same): unknown {
    if (typeof value !== 'object' || value === null) return typeof value === 'number' ? String(value) : value;
    const { parts, known } = tables.get(table) as NonNullable<ReturnType<typeof tables.get>>;
    const before = known.get(value);
    if (before !== undefined) return before;
    const part = told(value);
    const index = parts.push(part) - 1;
    known.set(value, index);
    return index;
  }

  const withPage = (value: unknown) =>
    isObject(value) && 'page' in value ? { ...value, page: named('pages', value.page) } : value;
  const listOf = (entries: keyof Tables) => (list: unknown) =>
    Array.isArray(list)
      ? Array.from(list, (entry) => named(entries, entry, entries === 'sheets' ? withPage : undefined))
      : list;

  function told(state: unknown) {
    if (!isObject(state)) return state;
    const made = { ...state };
    for (const [field, table] of PARTS) if (field in made) made[field] = named(table, made[field]);
    for (const [field, table, entries] of LISTS)
      if (field in made) made[field] = named(table, made[field], listOf(entries));
    return made;
  }

  const all = (states: unknown, change: (state: unknown) => unknown) =>
    Array.isArray(states) ? Array.from(states, change) : states;
  const { past, present, future, shown, ...rest } = history;
  const made = {
    past: all(past, told),
    present: told(present),
    future: all(future, told),
    shown: all(shown, withPage),
  };
  const parts = Object.fromEntries([...tables].map(([table, { parts }]) => [table, parts]));
  return { ...rest, parts, ...made };
}

/**
 * @param history from the core
 * @returns with shared parts
 */
export function expanded({ parts, past, present, future, shown }: TabledHistory): History {
  const { state, withPage } = joinedWith(parts);
  const whole = (kept: KeptState) => state(kept) as Project;
  return { past: past.map(whole), present: whole(present), future: future.map(whole), shown: shown.map(withPage) };
}

/** Initial content of tables, as in states. */
export type Known = Partial<Omit<Tables, 'sheets'>> & { sheets?: readonly Sheet[] };

/**
 * @param told tables from the core
 * @param known parts at the start of the tables
 * @returns functions that replace indices by parts: in a state or some of its fields, in objects with a page, and in edits
 */
export function joinedWith(told: Tables, known: Known = {}) {
  const pages = joined(known.pages, told.pages);
  const paged = <Entry extends { page: number }>(entry: Entry): Omit<Entry, 'page'> & { page: PageDocument } => ({
    ...entry,
    page: pages[entry.page],
  });
  const styles = listed(told.shelves, joined(known.styles, told.styles));
  const tables: { [Field in Tabled]: readonly unknown[] } = {
    tray: listed(told.trays, joined(known.items, told.items)),
    settings: joined(known.settings, told.settings),
    page: pages,
    others: listed(told.books, joined(known.sheets, told.sheets.map(paged))),
    draft: joined(known.drafts, told.drafts),
    board: joined(known.boards, told.boards),
    mine: styles,
    favourites: styles,
    waiting: listed(told.waits, joined(known.words, told.words)),
    ownLayouts: listed(told.layoutShelves, joined(known.layouts, told.layouts)),
  };
  const part = (field: string, value: unknown) =>
    isTabled(field) && typeof value === 'number' ? tables[field][value] : value;

  return {
    // The order of the fields is preserved, because some of the output is compared as text.
    state: (fields: Partial<KeptState>): Partial<Project> =>
      Object.fromEntries(Object.entries(fields).map(([field, value]) => [field, part(field, value)])),
    withPage: (entry: KeptShown): Shown => paged(entry),
    edit: (edit: KeptEdit): Edit & How => {
      if (edit.type === 'set-sheets') return { ...edit, sheets: edit.sheets.map(paged) };
      if (edit.type === 'no-page') return edit;
      const page = edit.page === undefined ? null : pages[edit.page];
      if (edit.type === 'change-settings')
        return { ...edit, page, settings: tables.settings[edit.settings] as PageSettings };
      return { ...edit, page: page as PageDocument };
    },
  };

  function isTabled(field: string): field is Tabled {
    return field in tables;
  }
}

function joined<T>(known: readonly T[] = [], told: readonly T[]): readonly T[] {
  return [...known, ...told];
}

function listed<T>(lists: readonly (readonly number[])[], entries: readonly T[]): readonly (readonly T[])[] {
  return lists.map((list) => list.map((i) => entries[i]));
}

function isObject(value: unknown): value is Plain {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
