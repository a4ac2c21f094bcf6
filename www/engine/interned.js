// @ts-check
/**
 * A history as it crosses to the core and back: states share most of their parts, so these stand in tables beside the
 * states, which name them by their index (`src/document/kept.rs` has the tables). 500 states of one tray cost one tray.
 */

/** As a history is kept: states of a project, and the pages shown. @typedef {{ past: any[], present: any, future: any[], shown: any[] }} KeptHistory */
/** @typedef {Record<string, any>} Plain */

/** What of a state stands in a table. @type {readonly [field: string, table: string][]} */
const PARTS = [['settings', 'settings'], ['page', 'pages'], ['draft', 'drafts']];
/** Which lists of a state stand in a table, and what is in them. @type {readonly [field: string, table: string, entries: string][]} */
const LISTS = [
  ['tray', 'trays', 'items'], ['others', 'books', 'sheets'], ['mine', 'shelves', 'styles'], ['favourites', 'shelves', 'styles'],
  ['ownLayouts', 'layoutShelves', 'layouts'],
];
const TABLES = ['items', 'trays', 'pages', 'sheets', 'books', 'styles', 'shelves', 'layouts', 'layoutShelves', 'settings', 'drafts'];

/**
 * @param {unknown} history of a record, which may be anything
 * @returns {Plain} with `parts`
 */
export function interned(history) {
  if (!isObject(history)) return /** @type {any} */ (history);
  const parts = /** @type {Record<string, any[]>} */ (Object.fromEntries(TABLES.map((table) => [table, []])));
  const known = new Map(TABLES.map((table) => [table, new Map()]));

  /**
   * @param {string} table
   * @param {unknown} value
   * @param {(value: any) => unknown} [told] the part as the table has it
   * @returns {unknown} its index; what is no part at all stays, but never looks like an index
   */
  function named(table, value, told = (same) => same) {
    if (typeof value !== 'object' || value === null) return typeof value === 'number' ? String(value) : value;
    const places = /** @type {Map<unknown, number>} */ (known.get(table));
    const before = places.get(value);
    if (before !== undefined) return before;
    const part = told(value);
    const index = parts[table].push(part) - 1;
    places.set(value, index);
    return index;
  }

  const withPage = (/** @type {any} */ value) => (isObject(value) && 'page' in value ? { ...value, page: named('pages', value.page) } : value);
  const listOf = (/** @type {string} */ entries) => (/** @type {any} */ list) => (
    Array.isArray(list) ? Array.from(list, (entry) => named(entries, entry, entries === 'sheets' ? withPage : undefined)) : list
  );

  /** @param {any} state */
  function told(state) {
    if (!isObject(state)) return state;
    const made = { ...state };
    for (const [field, table] of PARTS) if (field in made) made[field] = named(table, made[field]);
    for (const [field, table, entries] of LISTS) if (field in made) made[field] = named(table, made[field], listOf(entries));
    return made;
  }

  const all = (/** @type {any} */ states, /** @type {(state: any) => any} */ change) => (Array.isArray(states) ? Array.from(states, change) : states);
  const { past, present, future, shown, ...rest } = history;
  return { ...rest, parts, past: all(past, told), present: told(present), future: all(future, told), shown: all(shown, withPage) };
}

/**
 * @param {Plain} history with `parts`, as the core gives it
 * @returns {KeptHistory} in which states share what they shared
 */
export function expanded({ parts, past, present, future, shown }) {
  const withPage = (/** @type {any} */ entry) => ({ ...entry, page: parts.pages[entry.page] });
  const sheets = parts.sheets.map(withPage);
  const lists = Object.fromEntries(LISTS.map(([, table, entries]) => {
    const from = entries === 'sheets' ? sheets : parts[entries];
    return [table, parts[table].map((/** @type {number[]} */ list) => list.map((i) => from[i]))];
  }));

  const whole = (/** @type {any} */ state) => {
    const made = { ...state };
    for (const [field, table] of PARTS) made[field] = made[field] === null ? null : parts[table][made[field]];
    for (const [field, table] of LISTS) made[field] = lists[table][made[field]];
    return made;
  };
  return { past: past.map(whole), present: whole(present), future: future.map(whole), shown: shown.map(withPage) };
}

/** @param {unknown} value @returns {value is Plain} */
function isObject(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
