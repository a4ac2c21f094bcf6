// @ts-check
/** Access to the app's database, to simulate faults and manipulated data. */

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {'projects' | 'states' | 'facts' | 'photos'} Table */

/** A file of the site without the app, so that no other code has the tables open. */
const ELSEWHERE = './icon.svg';

/** Helper functions for the tables, as code that runs in the page. */
const HANDS = `
  const open = (name, upgrade) => new Promise((resolve, reject) => {
    const request = indexedDB.open(name, 1);
    request.onupgradeneeded = () => upgrade?.(request.result);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  const TABLES = ['projects', 'states', 'facts', 'photos'];
  const made = (base) => TABLES.forEach((table) => base.objectStoreNames.contains(table) || base.createObjectStore(table, { keyPath: 'id' }));
  const all = (base, table) => new Promise((resolve) => { base.transaction(table).objectStore(table).getAll().onsuccess = ({ target }) => resolve(target.result); });
  const get = (base, table, key) => new Promise((resolve) => { base.transaction(table).objectStore(table).get(key).onsuccess = ({ target }) => resolve(target.result); });
  const fill = (base, table, records) => new Promise((resolve, reject) => {
    const turn = base.transaction(table, 'readwrite');
    turn.objectStore(table).clear();
    for (const record of records) turn.objectStore(table).put(record);
    turn.oncomplete = resolve;
    turn.onerror = () => reject(turn.error);
  });
`;

/** Leaves the page, so that only the test accesses the tables. @param {Page} page */
export async function leave(page) {
  // Browsers request it for a document without an icon.
  await page.route('**/favicon.ico', (route) => route.fulfill({ status: 204 }));
  await page.goto(ELSEWHERE);
}

/** Keeps a copy of all tables. @param {Page} page that was left */
export async function backUp(page) {
  await page.evaluate(`(async () => { ${HANDS}
    const [from, to] = [await open('inkpanel', made), await open('backup', made)];
    for (const table of TABLES) await fill(to, table, await all(from, table));
    from.close(); to.close();
  })()`);
}

/**
 * Restores the tables from the copy, and changes one of them.
 * @param {Page} page that was left
 * @param {Table} table
 * @param {string} change an expression of the original `record` and `i`, for the new record; undefined removes it
 */
export async function spoil(page, table, change) {
  await page.evaluate(`(async () => { ${HANDS}
    const [from, to] = [await open('backup', made), await open('inkpanel', made)];
    for (const table of TABLES) {
      const records = await all(from, table);
      const isState = ({ id }) => table !== 'states' || (id !== 'orphans' && !id.startsWith('drawn '));
      await fill(to, table, table !== '${table}' ? records : records.flatMap((record, i) => {
        const other = isState(record) ? (${change}) : record;
        return other === undefined ? [] : [other];
      }));
    }
    from.close(); to.close();
    localStorage.removeItem('inkpanel.project');
    sessionStorage.removeItem('inkpanel.project');
    localStorage.setItem('inkpanel.project', (await open('backup').then((base) => all(base, 'projects')))[0].id);
  })()`);
}

/**
 * All that the tables hold, Blobs by their bytes: the same text is the same in every byte.
 * @param {Page} page
 * @param {{ of?: string }} [only] the records of one project and of its photos
 * @returns {Promise<Record<Table, Record<string, any>>>}
 */
export async function tables(page, { of = '' } = {}) {
  return page.evaluate(`(async () => { ${HANDS}
    const base = await open('inkpanel', made);
    const digest = async (blob) => {
      const bytes = await crypto.subtle.digest('SHA-256', await blob.arrayBuffer());
      return 'blob ' + blob.size + ' ' + [...new Uint8Array(bytes)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
    };
    const told = async (value) => {
      if (value instanceof Blob) return digest(value);
      if (Array.isArray(value)) return Promise.all(value.map(told));
      if (value instanceof Map) return told(Object.fromEntries(value));
      if (typeof value !== 'object' || value === null) return value;
      return Object.fromEntries(await Promise.all(Object.entries(value).map(async ([key, part]) => [key, await told(part)])));
    };
    const project = '${of}' === '' ? null : await get(base, 'projects', '${of}');
    const found = {};
    for (const table of TABLES) {
      // All projects together have too much data to check.
      const keys = ['projects', 'states'].includes(table) ? ['${of}'] : project?.refs ?? [];
      const records = project === null ? await all(base, table) : (await Promise.all(keys.map((key) => get(base, table, key)))).filter(Boolean);
      found[table] = Object.fromEntries(await Promise.all(records.map(async (record) => [record.id, await told(record)])));
    }
    base.close();
    return found;
  })()`);
}
