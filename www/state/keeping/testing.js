// @ts-check
/** A browser's storage for the tests of keeping: tabs that share tables, locks and small storages. */

import 'fake-indexeddb/auto';
import { IDBFactory } from 'fake-indexeddb';
import { createPhotos } from '../../engine/photos.js';
import { createMessages } from '../messages.js';
import { createPages } from '../pages.js';
import { createStore } from '../store.js';
import { fakePlanner } from '../testing.js';
import { createKeeping } from './keeping.js';
import { createShelves } from './shelves.js';
import { fakeReading } from './testing-reading.js';
import { createReading } from '../reading.js';
import { unreadMeta } from '../album.js';

/** Locks as the browser has them, in the little that is used: exclusive and shared, waited for or not. */
function fakeLocks() {
  /** @type {Map<string, { shared: boolean, count: number }>} */
  const held = new Map();
  /** @type {(() => boolean)[]} */
  let queue = [];
  const settle = () => { queue = queue.filter((attempt) => !attempt()); };
  return {
    async request(/** @type {string} */ name, /** @type {any} */ { mode = 'exclusive', ifAvailable = false, signal }, /** @type {any} */ work) {
      const free = () => !held.has(name) || (mode === 'shared' && held.get(name)?.shared);
      const run = async () => {
        const now = held.get(name) ?? { shared: mode === 'shared', count: 0 };
        held.set(name, { ...now, count: now.count + 1 });
        try {
          return await work({ name });
        } finally {
          const after = /** @type {any} */ (held.get(name));
          if (after.count === 1) held.delete(name);
          else held.set(name, { ...after, count: after.count - 1 });
          settle();
        }
      };
      if (free()) return run();
      if (ifAvailable) return work(null);
      return new Promise((resolve, reject) => {
        let over = false;
        signal?.addEventListener('abort', () => { over = true; reject(signal.reason); });
        queue.push(() => {
          if (over) return true;
          if (!free()) return false;
          resolve(run());
          return true;
        });
      });
    },
  };
}

/** A small storage. */
function boxOf() {
  /** @type {Map<string, string>} */
  const kept = new Map();
  return {
    getItem: (/** @type {string} */ key) => kept.get(key) ?? null,
    setItem: (/** @type {string} */ key, /** @type {string} */ value) => void kept.set(key, value),
    removeItem: (/** @type {string} */ key) => void kept.delete(key),
    key: (/** @type {number} */ at) => [...kept.keys()][at] ?? null,
    get length() { return kept.size; },
  };
}

/** @type {(() => void)[]} */
const living = [];

/** Ends all tabs of all browsers, which would else go on saving during the next test. */
export function allDie() {
  living.splice(0).forEach((die) => die());
}

/**
 * A browser: what its tabs share.
 * @param {{ factory?: IDBFactory, local?: ReturnType<typeof boxOf> }} [before] the same after all of its tabs have died
 */
export function fakeBrowser({ factory = new IDBFactory(), local = boxOf() } = {}) {
  Object.assign(globalThis, { indexedDB: factory });
  const locks = fakeLocks();
  living.push(die);
  return { factory, local, locks, tab, died: () => { die(); return fakeBrowser({ factory, local }); } };

  /** All of its tabs die: what they were about to do is not done. */
  function die() {
    // Whatever is written waits for a lock.
    locks.request = () => new Promise(() => {});
  }

  /**
   * @param {{
   *   session?: ReturnType<typeof boxOf>, views?: import('./opening.js').Views, prepare?: (tab: any) => void,
   * }} [of] a tab that is loaded again has the session it had; `prepare` comes before it opens anything
   */
  async function tab({ session = boxOf(), views, prepare = () => {} } = {}) {
    const store = createStore();
    const planner = fakePlanner();
    /** @type {any} */ (planner).checkStyle = JSON.parse;
    /** @type {any} */ (planner).geometry = (/** @type {any} */ layout) => {
      const count = Number(String(layout.id ?? layout).slice(1));
      if (!(count > 0)) throw new Error('no such layout');
      return { width: 1, height: 1, panels: Array.from({ length: count }, () => ({})) };
    };
    Object.assign(planner, fakeReading(/** @type {any} */ (planner).geometry));
    store.planner.value = /** @type {any} */ (planner);
    const messages = createMessages();
    let seed = 0;
    const pages = createPages(store, () => (seed += 1));
    const photos = createPhotos();
    const decoded = /** @type {string[]} */ ([]);
    const engine = /** @type {any} */ ({
      ready: Promise.resolve(planner), photos, hasPhoto: photos.has, forgetPhoto: photos.forget,
      importPhoto: async (/** @type {string} */ id, /** @type {File} */ file) => {
        const text = await file.text();
        if (text.startsWith('bad')) throw Object.assign(new Error('not a photo'), { code: 'unsupported-format' });
        decoded.push(file.name);
        const handle = (/** @type {string} */ tier) => ({ key: `${id}/${tier}`, width: 2, height: 1, planes: new Blob([`${tier} of ${file.name}`]) });
        photos.add(id, { name: file.name, file, work: handle('work'), small: handle('small') });
        // The same file looks the same wherever it is read.
        return { ...unreadMeta(id), fingerprint: unreadMeta(text).fingerprint, measures: { twin: 0 } };
      },
      renderPage: () => Promise.reject(new Error('no pixels here')),
    });
    const reading = createReading({ store, pages, engine, messages, prefix: `p${Math.random()}-` });
    const shelves = createShelves({ store, messages, box: () => local });
    shelves.recall();
    const window = /** @type {any} */ (Object.assign(new EventTarget(), {
      navigator: { locks, storage: {} }, sessionStorage: session, localStorage: local,
      document: Object.assign(new EventTarget(), { visibilityState: 'visible' }),
    }));
    /** Whether the tab asks before it closes. */
    const asks = () => !window.dispatchEvent(new Event('beforeunload', { cancelable: true }));
    const keeping = createKeeping({ store, reading, engine, shelves, messages, window, leave: () => {}, views });
    prepare({ engine });
    await keeping.begin();
    const files = (/** @type {string[]} */ ...names) => names.map((name) => new File([name], name));
    const add = async (/** @type {string[]} */ ...names) => {
      await reading.addFiles(files(...names));
      await keeping.flush();
    };
    const names = () => store.facts.peek().map(({ name }) => name);
    return { store, pages, reading, keeping, messages, engine, photos, decoded, session, window, shelves, asks, add, files, names };
  }
}

/** What a person can tell of a project. @param {{ store: import('../store.js').Store }} tab */
export function documentOf({ store }) {
  const { gesture: _gesture, ...history } = store.history.peek();
  return structuredClone(history);
}
