/** A browser's storage for the tests of keeping: tabs that share tables, locks and small storages. */

import { createScheduler } from '../engine/scheduler.ts';
import 'fake-indexeddb/auto';
import { IDBFactory } from 'fake-indexeddb';
import { createPhotos } from '../engine/photos.ts';
import { createMessages } from '../ui/messages.ts';
import { createPages } from '../document/pages.ts';
import { createStore } from '../document/store.ts';
import { fakePlanner, historyOf } from '../document/testing.ts';
import { createKeeping, type Keeping } from './storage.ts';
import { createShelves } from './shelves.ts';
import { core } from '../engine/testing-core.ts';
import { createReading, type Reading } from '../photos/reading.ts';
import { unreadMeta } from '../document/album.ts';
import type { Store } from '../document/store.ts';
import { expanded, recordIn } from '../engine/interned.ts';
import type { History } from '../engine/types.ts';
import type { AnyState } from './database.ts';
import type { Views } from './opening.ts';

/** Locks as the browser has them, in the little that is used: exclusive and shared, waited for or not. */
function fakeLocks() {
  const held: Map<string, { shared: boolean; count: number }> = new Map();
  let queue: (() => boolean)[] = [];
  const settle = () => {
    queue = queue.filter((attempt) => !attempt());
  };
  return {
    async request(name: string, { mode = 'exclusive', ifAvailable = false, signal }: any, work: any) {
      const free = () => !held.has(name) || (mode === 'shared' && held.get(name)?.shared);
      const run = async () => {
        const now = held.get(name) ?? { shared: mode === 'shared', count: 0 };
        held.set(name, { ...now, count: now.count + 1 });
        try {
          return await work({ name });
        } finally {
          const after = held.get(name) as any;
          if (after.count === 1) held.delete(name);
          else held.set(name, { ...after, count: after.count - 1 });
          settle();
        }
      };
      if (free()) return run();
      if (ifAvailable) return work(null);
      return new Promise((resolve, reject) => {
        let over = false;
        signal?.addEventListener('abort', () => {
          over = true;
          reject(signal.reason);
        });
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
  const kept: Map<string, string> = new Map();
  return {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
    removeItem: (key: string) => void kept.delete(key),
    key: (at: number) => [...kept.keys()][at] ?? null,
    get length() {
      return kept.size;
    },
  };
}

const living: (() => void)[] = [];

/** Ends all tabs of all browsers, which would otherwise save during the next test. */
export function allDie() {
  living.splice(0).forEach((die) => die());
}

/**
 * A browser: the shared storage of its tabs.
 * @param before the same after all of its tabs have died
 */
export function fakeBrowser({
  factory = new IDBFactory(),
  local = boxOf(),
}: {
  factory?: IDBFactory;
  local?: ReturnType<typeof boxOf>;
} = {}) {
  Object.assign(globalThis, { indexedDB: factory });
  const locks = fakeLocks();
  living.push(die);
  return {
    factory,
    local,
    locks,
    tab,
    died: () => {
      die();
      return fakeBrowser({ factory, local });
    },
  };

  /** Kills all tabs without finishing their pending work. */
  function die() {
    // Whatever is written waits for a lock.
    locks.request = () => new Promise(() => {});
  }

  /** a reloaded tab keeps its session; `prepare` runs before it opens a project, `early` while it does */
  async function tab({
    session = boxOf(),
    views,
    prepare = () => {},
    early = () => {},
  }: {
    session?: ReturnType<typeof boxOf>;
    views?: Views;
    prepare?: (tab: any) => void;
    early?: (tab: { keeping: Keeping; reading: Reading }) => void;
  } = {}) {
    const store = createStore();
    const planner = fakePlanner();
    const { checkStyle, geometry, readProject } = core;
    Object.assign(planner, { checkStyle, geometry, readProject });
    store.planner.value = planner as any;
    const messages = createMessages();
    let seed = 0;
    const pages = createPages(store, { seed: () => (seed += 1) });
    const photos = createPhotos();
    const decoded = [] as string[];
    const engine = {
      facesReady: () => true,
      ready: Promise.resolve(planner),
      photos,
      hasPhoto: photos.has,
      forgetPhoto: photos.forget,
      importDraft: () => null,
      isDraft: () => false,
      importPhoto: async (id: string, file: File) => {
        const text = await file.text();
        if (text.startsWith('bad')) throw Object.assign(new Error('not a photo'), { code: 'unknown-format' });
        decoded.push(file.name);
        const handle = (tier: string) => ({
          key: `${id}/${tier}`,
          width: 2,
          height: 1,
          planes: new Blob([`${tier} of ${file.name}`]),
        });
        photos.add(id, { name: file.name, file, work: handle('work'), small: handle('small') });
        // The same file always has the same fingerprint.
        return { ...unreadMeta(id), fingerprint: unreadMeta(text).fingerprint, measures: { twin: 0 } };
      },
      renderPage: () => Promise.reject(new Error('no pixels here')),
    } as any;
    const reading = createReading({ store, pages, engine, messages, prefix: `p${Math.random()}-` });
    const shelves = createShelves({ store, messages, box: () => local });
    shelves.recall();
    const window = Object.assign(new EventTarget(), {
      navigator: { locks, storage: {} },
      sessionStorage: session,
      localStorage: local,
      document: Object.assign(new EventTarget(), { visibilityState: 'visible' }),
    }) as any;
    /** Whether the tab asks for confirmation before it closes. */
    const asks = () => !window.dispatchEvent(new Event('beforeunload', { cancelable: true }));
    const scheduler = createScheduler();
    const leave = () => {};
    const keeping = createKeeping({ store, reading, engine, scheduler, shelves, messages, window, leave, views });
    prepare({ engine });
    const begun = keeping.begin();
    early({ keeping, reading });
    await begun;
    const files = (...names: string[]) => names.map((name) => new File([name], name, { lastModified: 0 }));
    const add = async (...names: string[]) => {
      await reading.addFiles(files(...names));
      await keeping.flush();
    };
    const names = () => store.facts.peek().map(({ name }) => name);
    return {
      store,
      pages,
      reading,
      keeping,
      messages,
      engine,
      scheduler,
      photos,
      decoded,
      session,
      window,
      shelves,
      asks,
      add,
      files,
      names,
    };
  }
}

/** The history in a record of the table `states`. */
export function historyIn({ bytes }: Partial<AnyState>): History {
  return expanded(recordIn(bytes as Uint8Array).history);
}

/** A record of the table `states` as earlier versions wrote it. */
export function earlier({ bytes, ...record }: AnyState): AnyState {
  return bytes ? { ...record, version: 1, history: historyIn({ bytes }) } : record;
}

/** The history of a project. */
export function documentOf({ store }: { store: Store }) {
  return historyOf(store.editing());
}
