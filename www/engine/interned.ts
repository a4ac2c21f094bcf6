/**
 * A history as it crosses to the core and back: states share most of their parts, so these stand in tables beside the
 * states, which name them by their index (`src/document/kept.rs` has the tables). 500 states of one tray cost one tray.
 */

/** As a history is kept: states of a project, and the pages shown. */
export type KeptHistory = { past: readonly any[]; present: any; future: readonly any[]; shown: readonly any[] };
type Plain = Record<string, any>;

/** What of a state stands in a table. */
const PARTS: readonly [field: string, table: string][] = [
  ['settings', 'settings'],
  ['page', 'pages'],
  ['draft', 'drafts'],
];
/** Which lists of a state stand in a table, and what is in them. */
const LISTS: readonly [field: string, table: string, entries: string][] = [
  ['tray', 'trays', 'items'],
  ['others', 'books', 'sheets'],
  ['mine', 'shelves', 'styles'],
  ['favourites', 'shelves', 'styles'],
  ['ownLayouts', 'layoutShelves', 'layouts'],
];
const TABLES = [
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
];

/**
 * @param history of a record, which may be anything
 * @returns with `parts`
 */
export function interned(history: unknown): Plain {
  if (!isObject(history)) return history as any;
  const parts = Object.fromEntries(TABLES.map((table) => [table, []])) as Record<string, any[]>;
  const known = new Map(TABLES.map((table) => [table, new Map()]));

  /**
   * @param told the part as the table has it
   * @returns its index; what is no part at all stays, but never looks like an index
   */
  function named(table: string, value: unknown, told: (value: any) => unknown = (same) => same): unknown {
    if (typeof value !== 'object' || value === null) return typeof value === 'number' ? String(value) : value;
    const places = known.get(table) as Map<unknown, number>;
    const before = places.get(value);
    if (before !== undefined) return before;
    const part = told(value);
    const index = parts[table].push(part) - 1;
    places.set(value, index);
    return index;
  }

  const withPage = (value: any) =>
    isObject(value) && 'page' in value ? { ...value, page: named('pages', value.page) } : value;
  const listOf = (entries: string) => (list: any) =>
    Array.isArray(list)
      ? Array.from(list, (entry) => named(entries, entry, entries === 'sheets' ? withPage : undefined))
      : list;

  function told(state: any) {
    if (!isObject(state)) return state;
    const made = { ...state };
    for (const [field, table] of PARTS) if (field in made) made[field] = named(table, made[field]);
    for (const [field, table, entries] of LISTS)
      if (field in made) made[field] = named(table, made[field], listOf(entries));
    return made;
  }

  const all = (states: any, change: (state: any) => any) =>
    Array.isArray(states) ? Array.from(states, change) : states;
  const { past, present, future, shown, ...rest } = history;
  return {
    ...rest,
    parts,
    past: all(past, told),
    present: told(present),
    future: all(future, told),
    shown: all(shown, withPage),
  };
}

/** Tables of parts, by their names. */
export type Tables = Record<string, readonly any[]>;

/**
 * @param history with `parts`, as the core gives it
 * @returns in which states share what they shared
 */
export function expanded({ parts, past, present, future, shown }: Plain): KeptHistory {
  const { state, withPage } = joinedWith(parts);
  return { past: past.map(state), present: state(present), future: future.map(state), shown: shown.map(withPage) };
}

/**
 * @param told tables as the core gives them
 * @param known parts with which they begin, as they are in states
 * @returns what puts parts in the place of their numbers: in a state or some fields of it, and in what has a page
 */
export function joinedWith(told: Tables, known: Tables = {}) {
  const all = (table: string, made: readonly any[] = told[table]) => [...(known[table] ?? []), ...made];
  const pages = all('pages');
  const withPage = (entry: any) => ({ ...entry, page: pages[entry.page] });
  const tables: Tables = {
    ...Object.fromEntries(TABLES.map((table) => [table, all(table)])),
    sheets: all('sheets', told.sheets.map(withPage)),
  };
  const lists = Object.fromEntries(
    LISTS.map(([, table, entries]) => [
      table,
      told[table].map((list: number[]) => list.map((i) => tables[entries][i])),
    ]),
  );

  const state = (fields: Plain) => {
    const made = { ...fields };
    for (const [field, table] of PARTS) if (typeof made[field] === 'number') made[field] = tables[table][made[field]];
    for (const [field, table] of LISTS) if (field in made) made[field] = lists[table][made[field]];
    return made;
  };
  return { state, withPage };
}

function isObject(value: unknown): value is Plain {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
