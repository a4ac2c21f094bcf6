import { afterEach, describe, expect, it, vi } from 'vitest';
import { openDatabase } from './database.ts';
import { allDie, fakeBrowser, historyIn } from './testing.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));
afterEach(() => {
  allDie();
  vi.restoreAllMocks();
});

type Tab = Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;

const SIX = ['a.jpg', 'b.jpg', 'c.jpg', 'd.jpg', 'e.jpg', 'f.jpg'];

const thrownAway = (factory: IDBFactory) =>
  new Promise((resolve, reject) => {
    const request = factory.deleteDatabase('inkpanel');
    request.onsuccess = () => resolve(undefined);
    request.onerror = () => reject(request.error);
  });

/** Numbers of records by table. */
async function counts() {
  const base = await openDatabase();
  const found = await Promise.all(
    (['projects', 'states', 'facts', 'photos'] as const).map((table) => base.count(table)),
  );
  base.close();
  return found;
}

/** @param names of files */
async function without(tab: Tab, ...names: string[]) {
  const ids = tab.store.facts.value.filter(({ name }) => names.includes(name)).map(({ id }) => id);
  const base = await openDatabase();
  await Promise.all(ids.map((id) => base.delete('photos', id)));
  base.close();
}

const rename = (tab: Tab, name: string) => tab.store.change({ type: 'rename', name });
const saved = (tab: Tab) => vi.waitFor(() => expect(tab.keeping.status.value).toBe('saved'), { timeout: 5000 });
const alerts = (tab: Tab) => tab.messages.list.value.filter(({ kind }) => kind === 'grave');
/** The photos that are empty frames. */
const absent = (tab: Tab) => tab.store.facts.value.filter((fact) => fact.absent).map(({ name }) => name);

/** Storage whose writes fail as `wrong` defines. */
function failing(wrong: (value: any) => Error | null) {
  const { put } = IDBObjectStore.prototype;
  return vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function spied(value: any, key) {
    const error = wrong(value);
    if (error) throw error;
    // @ts-expect-error -- `this` is the table
    return put.call(this, value, key);
  });
}

describe('saving waits for the page', () => {
  /** A scheduler that gives no turn until `go`. */
  function stopped({ scheduler }: Tab) {
    const gates: (() => void)[] = [];
    let open = false;
    const turn = vi.spyOn(scheduler, 'turn').mockImplementation((_lane, { signal } = {}) => {
      if (open) return Promise.resolve();
      return new Promise((resolve, reject) => {
        gates.push(resolve);
        signal?.addEventListener('abort', () => reject(new Error('aborted')));
      });
    });
    const go = () => {
      open = true;
      for (const gate of gates) gate();
    };
    return { turn, go };
  }

  it('and goes on when it is drawn, copies of photos after a rest', async () => {
    const tab = await fakeBrowser().tab();
    const { turn, go } = stopped(tab);
    await tab.reading.addFiles(tab.files(...SIX));
    await vi.waitFor(() => expect(turn).toHaveBeenCalledWith('requested', expect.anything()));
    expect(await counts()).toEqual([0, 0, 0, 0]);
    go();
    await saved(tab);
    expect((await counts())[3]).toBe(SIX.length);
    await vi.waitFor(() => expect(turn).toHaveBeenLastCalledWith('background', expect.anything()));
  });

  it('but not when the project is left', async () => {
    const tab = await fakeBrowser().tab();
    const { turn } = stopped(tab);
    await tab.reading.addFiles(tab.files(...SIX));
    await vi.waitFor(() => expect(turn).toHaveBeenCalled());
    await tab.keeping.flush();
    expect((await counts())[3]).toBe(SIX.length);
  });
});

describe('a draft of a photo', () => {
  const record = async (tab: Tab) => {
    const base = await openDatabase();
    const found = await base.get('photos', tab.store.facts.value[0].id);
    base.close();
    return found;
  };
  const reopened = async (browser: ReturnType<typeof fakeBrowser>) => {
    const tab = await fakeBrowser(browser).tab();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    return tab.decoded;
  };

  it('is not stored, but the photo that replaces it is', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    const { add } = tab.photos;
    const draft = (handle: any) => ({ ...handle, draft: true });
    const adding = vi.spyOn(tab.photos, 'add').mockImplementation((id, { work, small, ...entry }) => {
      add(id, { ...entry, work: draft(work), small: draft(small) });
    });
    await tab.add('a.jpg');
    expect(await record(tab)).toMatchObject({ name: 'a.jpg', work: null, small: null });
    expect(tab.keeping.status.value).toBe('saved');
    adding.mockRestore();
    const [fact] = tab.store.facts.value;
    const { work, small, ...entry } = tab.photos.get(fact.id);
    const whole = ({ draft: _, ...handle }: typeof work) => handle;
    tab.photos.add(fact.id, { ...entry, work: whole(work), small: whole(small) });
    tab.store.know({ ...fact, looked: true });
    await tab.keeping.flush();
    expect((await record(tab))?.work).toMatchObject({ key: `${fact.id}/work` });
    expect(await reopened(browser)).toEqual([]);
  });

  it('that an earlier version stored is decoded again', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    await tab.add('a.jpg');
    const stored = (await record(tab)) as any;
    const base = await openDatabase();
    await base.put('photos', { ...stored, work: { ...stored.work, draft: true } });
    base.close();
    expect(await reopened(browser)).toEqual(['a.jpg']);
  });
});

describe('a database that went', () => {
  it.each([
    ['at rest', false],
    ['before an edit', true],
  ])('under the page, %s, is made anew from what the page holds', async (_when, edit) => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    await tab.add(...SIX);
    rename(tab, 'Trip');
    await tab.keeping.flush();
    await thrownAway(browser.factory);
    if (edit) {
      rename(tab, 'Journey');
      await tab.keeping.flush();
      await saved(tab);
    }
    await vi.waitFor(async () => expect(await counts()).toEqual([1, 1, 6, 6]), { timeout: 5000 });
    await saved(tab);
    expect(alerts(tab)).toEqual([]);
    const id = tab.keeping.current.value;
    const after = await browser.died().tab();
    expect([after.keeping.current.value, after.store.project.value.name, after.names(), after.decoded]).toEqual([
      id,
      edit ? 'Journey' : 'Trip',
      SIX,
      [],
    ]);
  });

  it('while it is written to is made anew, too', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    await tab.add(...SIX);
    rename(tab, 'Trip');
    const writing = tab.keeping.flush();
    await thrownAway(browser.factory);
    await writing;
    await vi.waitFor(async () => expect(await counts()).toEqual([1, 1, 6, 6]), { timeout: 5000 });
    await saved(tab);
  });

  it('and that somebody else made again, without a table, is no hindrance', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    await tab.add('a.jpg');
    await thrownAway(browser.factory);
    await new Promise((resolve) => {
      const opening = browser.factory.open('inkpanel');
      opening.onsuccess = () => {
        opening.result.close();
        resolve(undefined);
      };
    });
    await vi.waitFor(async () => expect(await counts()).toEqual([1, 1, 1, 1]), { timeout: 5000 });
    await saved(tab);
  });

  it.each(['projects', 'states', 'facts', 'photos'] as const)(
    'with all of its %s is mended at the next save',
    async (table) => {
      const browser = fakeBrowser();
      const tab = await browser.tab();
      await tab.add('a.jpg', 'b.jpg');
      const base = await openDatabase();
      await base.clear(table);
      base.close();
      rename(tab, 'Trip');
      await tab.keeping.flush();
      expect([tab.keeping.status.value, ...(await counts())]).toEqual(['saved', 1, 1, 2, 2]);
    },
  );

  it('is not taken for saved when nothing written stays', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg');
    const keys = vi.spyOn(IDBObjectStore.prototype, 'getAllKeys').mockImplementation(function none() {
      // @ts-expect-error -- `this` is the table
      return this.getAll('nothing has this key');
    });
    rename(tab, 'Trip');
    await tab.keeping.flush();
    expect(tab.keeping.status.value).toBe('failed');
    keys.mockRestore();
  });

  it("takes nobody's own styles with it", async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    const style = { id: 'mine-1', name: 'Mine', tags: [], background: [] } as any;
    tab.store.change({ type: 'own-styles', mine: [style] });
    for (let at = browser.local.length - 1; at >= 0; at -= 1) browser.local.removeItem(browser.local.key(at) as string);
    tab.shelves.hear({ key: null });
    expect(tab.store.project.value.mine).toEqual([style]);
    expect(JSON.parse(browser.local.getItem('inkpanel.styles') ?? '')).toEqual([style]);
  });
});

describe('photos that the database lost', () => {
  it('are written again before it says saved', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    await tab.add(...SIX);
    await without(tab, 'b.jpg', 'e.jpg');
    rename(tab, 'Trip');
    await tab.keeping.flush();
    expect([tab.keeping.status.value, (await counts())[3]]).toEqual(['saved', 6]);
    const after = await browser.died().tab();
    expect([after.names(), absent(after), after.decoded]).toEqual([SIX, [], []]);
  });

  it('are looked for when the person comes back to the page', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add(...SIX);
    await without(tab, 'b.jpg');
    tab.window.document.dispatchEvent(new Event('visibilitychange'));
    await vi.waitFor(async () => expect((await counts())[3]).toBe(6));
    await saved(tab);
  });

  it('keep their places after a reload, are named, and go back when they are chosen', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add(...SIX);
    const panels = before.store.page.value?.panels.map(({ photo }) => photo);
    await without(before, 'b.jpg', 'e.jpg');
    const tab = await browser.died().tab();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    expect([tab.names(), absent(tab)]).toEqual([SIX, ['b.jpg', 'e.jpg']]);
    expect(tab.store.page.value?.panels.map(({ photo }) => photo)).toEqual(panels);
    expect(panels?.every((id) => id === null || tab.photos.has(id))).toBe(true);
    expect(alerts(tab).map(({ text, way, more }) => [text, way?.label, more?.label])).toEqual([
      [
        '2 of 6 photos are not in this browser: b.jpg, e.jpg. Choose or drop them to restore them.',
        'Choose photos',
        'Continue without',
      ],
    ]);
    await tab.keeping.flush();
    expect([tab.keeping.status.value, (await counts())[3]]).toEqual(['saved', 4]);

    expect(await tab.keeping.absentPhotos.fill(tab.files('e.jpg', 'b.jpg', 'new.jpg'))).toMatchObject([
      { name: 'new.jpg' },
    ]);
    await tab.keeping.flush();
    expect([tab.names(), absent(tab), tab.keeping.status.value, (await counts())[3]]).toEqual([SIX, [], 'saved', 6]);
  });

  it('can be gone on without, and undo has them back', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add(...SIX);
    await without(before, 'b.jpg', 'e.jpg');
    const tab = await browser.died().tab();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    alerts(tab)[0].more?.run();
    expect(tab.names()).toEqual(['a.jpg', 'c.jpg', 'd.jpg', 'f.jpg']);
    tab.pages.undo();
    expect(tab.names()).toEqual(SIX);
  });

  it('are kept as bytes where the database takes no Blob, as in a private window of WebKit', async () => {
    const browser = fakeBrowser();
    const refusal = new DOMException('Error preparing Blob/File data to be stored in object store', 'UnknownError');
    const holdsBlob = (value: any) =>
      [value.file, value.work?.planes, value.small?.planes].some((part) => part instanceof Blob);
    failing((value) => (holdsBlob(value) ? refusal : null));
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    await before.keeping.flush();
    await saved(before);
    expect(alerts(before)).toEqual([]);
    expect(await counts()).toEqual([1, 1, 2, 2]);
    const after = await browser.died().tab();
    await vi.waitFor(() => expect(after.store.reading.value).toBe(null));
    expect([after.names(), absent(after)]).toEqual([['a.jpg', 'b.jpg'], []]);
  });

  it('are photos again where they turn up after all', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const [, { id }] = before.store.facts.value;
    const base = await openDatabase();
    const record = await base.get('photos', id);
    await base.delete('photos', id);
    const without = browser.died();
    const between = await without.tab();
    await vi.waitFor(() => expect(between.store.reading.value).toBe(null));
    rename(between, 'Trip');
    await between.keeping.flush();
    expect([absent(between), await base.count('photos')]).toEqual([['b.jpg'], 1]);
    await base.put('photos', { ...(record as any), work: null, small: null });
    const after = await without.died().tab();
    await vi.waitFor(() => expect(after.store.reading.value).toBe(null));
    expect([after.names(), absent(after), after.store.facts.value.every(({ measures }) => measures !== null)]).toEqual([
      ['a.jpg', 'b.jpg'],
      [],
      true,
    ]);
  });

  it('of which nothing is known but their files are read anew', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const base = await openDatabase();
    await base.clear('facts');
    const tab = await browser.died().tab();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    expect([tab.names(), absent(tab), tab.store.facts.value.every(({ meta }) => meta !== null)]).toEqual([
      ['a.jpg', 'b.jpg'],
      [],
      true,
    ]);
  });

  it('keep their places where their files can be read no more', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const [, { id }] = before.store.facts.value;
    const base = await openDatabase();
    await base.put('photos', {
      ...((await base.get('photos', id)) as any),
      file: new File(['bad'], 'b.jpg'),
      work: null,
      small: null,
    });
    const tab = await browser.died().tab();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    expect([tab.names(), absent(tab)]).toEqual([['a.jpg', 'b.jpg'], ['b.jpg']]);
  });

  it('and that the page can read no more either are named, with ways on', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg', 'b.jpg');
    const [, { id }] = tab.store.facts.value;
    const gone = () =>
      Object.assign(new Blob(['gone']), { slice: () => ({ arrayBuffer: () => Promise.reject(new Error('gone')) }) });
    const { work, small, file } = tab.photos.get(id);
    tab.photos.add(id, {
      name: 'b.jpg',
      file: gone(),
      work: { ...work, planes: gone() },
      small: { ...small, planes: gone() },
    });
    await without(tab, 'b.jpg');
    let refused = true;
    failing((value) => (refused && value.id === id && value.name ? new Error('The blob cannot be read.') : null));
    rename(tab, 'Trip');
    await tab.keeping.flush();
    expect([tab.keeping.status.value, tab.asks(), await counts()]).toEqual(['missing', true, [1, 1, 2, 1]]);
    const said = () => alerts(tab).map(({ text, way, more }) => [text, way?.label, more?.label]);
    const text = 'b.jpg is not saved: its file can no longer be read. Everything else is saved.';
    expect(said()).toEqual([[text, 'Save again', 'Choose photos']]);
    alerts(tab)[0].way?.run();
    await vi.waitFor(() => expect(said()).toEqual([[text, 'Choose photos', 'Continue without']]));
    // It is available again.
    refused = false;
    tab.photos.add(id, { name: 'b.jpg', file, work, small });
    rename(tab, 'Journey');
    await tab.keeping.flush();
    expect(tab.keeping.status.value).toBe('missing');
    expect(await tab.keeping.absentPhotos.fill(tab.files('b.jpg'))).toEqual([]);
    await tab.keeping.flush();
    expect([tab.names(), tab.keeping.status.value, alerts(tab), tab.asks()]).toEqual([
      ['a.jpg', 'b.jpg'],
      'saved',
      [],
      false,
    ]);
  });
});

describe('a save that failed', () => {
  it('leaves what was there, and no half of it', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg');
    const base = await openDatabase();
    const all = () => Promise.all([base.getAll('projects'), base.getAll('states'), base.getAll('facts')]);
    const before = await all();
    const put = failing((value) => (value.bytes ? new Error('The disk has hiccups.') : null));
    rename(tab, 'Trip');
    await tab.keeping.flush();
    expect([tab.keeping.status.value, await all()]).toEqual(['failed', before]);
    put.mockRestore();
    await tab.keeping.flush();
    expect([tab.keeping.status.value, (await all())[0][0].name]).toEqual(['saved', 'Trip']);
  });

  it('is tried again by itself, with growing pauses, until it is done', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg');
    const put = failing(() => new Error('The disk has hiccups.'));
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
    try {
      rename(tab, 'Trip');
      const tries: number[] = [];
      for (let second = 1; second <= 20; second += 1) {
        const before = put.mock.calls.length;
        vi.advanceTimersByTime(1000);
        await new Promise((resolve) => {
          setImmediate(() => setImmediate(() => setImmediate(resolve)));
        });
        if (put.mock.calls.length > before) tries.push(second);
      }
      expect(tab.keeping.status.value).toBe('failed');
      expect(tries.length).toBeGreaterThanOrEqual(4);
      const pauses = tries.slice(1).map((second, i) => second - tries[i]);
      expect(pauses.every((pause, i) => i === 0 || pause >= pauses[i - 1])).toBe(true);
      expect(pauses.at(-1)).toBeGreaterThan(pauses[0]);
      expect(alerts(tab).length).toBe(1);
    } finally {
      vi.useRealTimers();
    }
    put.mockRestore();
    await tab.keeping.flush();
    expect([tab.keeping.status.value, alerts(tab)]).toEqual(['saved', []]);
  });
});

it('lists no project whose files could not be read, and lists it when a photo comes', async () => {
  const tab = await fakeBrowser().tab();
  const list = async () => {
    await tab.keeping.flush();
    await tab.keeping.refresh();
    return tab.keeping.list.value.length;
  };
  await tab.reading.addFiles([new File(['bad'], 'notes.txt')]);
  expect([tab.store.tray.value.length, await list()]).toEqual([0, 0]);
  await tab.reading.addFiles(tab.files('a.jpg'));
  expect(await list()).toBe(1);
});

describe('hundreds of photos', () => {
  it('are in the state before the first of them is written; what comes through is there after a reload, and the rest is named', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    // No photo is decoded, and only some of the files are written.
    before.engine.importPhoto = () => new Promise(() => {});
    let through = 0;
    const { put } = IDBObjectStore.prototype;
    const stuck = vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function spied(value: any, key) {
      if (value.file && (through += 1) > 41) throw new Error('The page is about to die.');
      // @ts-expect-error -- `this` is the table
      return put.call(this, value, key);
    });
    const names = Array.from({ length: 300 }, (_, i) => `photo${i}.jpg`);
    void before.reading.addFiles(before.files(...names));
    await vi.waitFor(() => expect(before.keeping.status.value).toBe('failed'), { timeout: 5000 });
    expect([before.asks(), (await counts()).slice(0, 3)]).toEqual([true, [1, 1, 300]]);
    const later = browser.died();
    stuck.mockRestore();
    const files = (await counts())[3];
    expect(files).toBeGreaterThan(0);

    const after = await later.tab();
    await vi.waitFor(() => expect(after.store.reading.value).toBe(null), { timeout: 10_000 });
    expect([after.names(), absent(after).length]).toEqual([names, 300 - files]);
    expect(alerts(after).map(({ text }) => text)).toEqual([
      expect.stringContaining(`${300 - files} of 300 photos are not in this browser: photo`),
    ]);
    // Their look is unknown, so their names identify them.
    expect(await after.keeping.absentPhotos.fill(after.files(...absent(after)))).toEqual([]);
    expect([after.names(), absent(after)]).toEqual([names, []]);
  });

  it('are counted while they are written, and the tab asks until they are', async () => {
    const tab = await fakeBrowser().tab();
    tab.engine.importPhoto = () => new Promise(() => {});
    const seen: string[] = [];
    tab.keeping.progress.subscribe((now) => {
      if (now)
        queueMicrotask(() =>
          seen.push(`${tab.keeping.status.value} ${now.done} of ${now.total}${tab.asks() ? ', asks' : ''}`),
        );
    });
    void tab.reading.addFiles(tab.files(...Array.from({ length: 100 }, (_, i) => `photo${i}.jpg`)));
    await vi.waitFor(() => expect(tab.store.tray.value.length).toBe(100));
    await saved(tab);
    expect(seen).toEqual([
      'saving 0 of 100, asks',
      'saving 40 of 100, asks',
      'saving 80 of 100, asks',
      'saving 100 of 100',
    ]);
    expect([tab.keeping.progress.value, tab.asks()]).toEqual([null, false]);
  });

  it.each([
    ['what the journal cannot tell', false],
    ['nothing that the journal tells', true],
  ])('let %s pass before them', async (_what, tells) => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    tab.engine.importPhoto = () => new Promise(() => {});
    if (!tells)
      vi.spyOn(browser.local, 'setItem').mockImplementation(() => {
        throw new Error('full');
      });
    const { put } = IDBObjectStore.prototype;
    const order: string[] = [];
    vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function spied(value: any, key) {
      if (value.file) order.push('file');
      if (value.bytes) order.push(historyIn(value).present.name);
      if (order.length === 43) {
        rename(tab, 'Trip');
        void tab.keeping.flush();
      }
      // @ts-expect-error -- `this` is the table
      return put.call(this, value, key);
    });
    void tab.reading.addFiles(tab.files(...Array.from({ length: 160 }, (_, i) => `photo${i}.jpg`)));
    await saved(tab);
    const rest = order.slice(order.indexOf('Trip'));
    expect([rest.filter((what) => what === 'file').length > 0, order.filter((what) => what === 'file').length]).toEqual(
      [!tells, 160],
    );
  });

  it('of which one is no file any more are saved but for that one', async () => {
    const tab = await fakeBrowser().tab();
    tab.engine.importPhoto = () => new Promise(() => {});
    const files = tab.files('a.jpg', 'b.jpg', 'c.jpg');
    Object.assign(files[1], { slice: () => ({ arrayBuffer: () => Promise.reject(new Error('gone')) }) });
    failing((value) => (value.file && value.name === 'b.jpg' ? new Error('The blob cannot be read.') : null));
    void tab.reading.addFiles(files);
    await vi.waitFor(() => expect(tab.keeping.status.value).toBe('missing'));
    expect((await counts())[3]).toBe(2);
    expect(alerts(tab)[0].text).toBe('b.jpg is not saved: its file can no longer be read. Everything else is saved.');
  });

  it('that were chosen before the page could take them are asked for, too', async () => {
    const tab = await fakeBrowser().tab();
    let go = () => {};
    tab.engine.ready = new Promise((resolve) => {
      go = () => resolve(tab.store.planner.value);
    });
    const adding = tab.reading.addFiles(tab.files('a.jpg'));
    expect(tab.asks()).toBe(true);
    go();
    await adding;
    await tab.keeping.flush();
    expect(tab.asks()).toBe(false);
  });

  it('of which nothing was written are named in the tab that had them', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    const later = browser.died();
    void before.add('a.jpg', 'b.jpg');
    await vi.waitFor(() => expect(before.store.tray.value.length).toBe(2));
    const after = await later.tab({ session: before.session });
    expect(alerts(after).map(({ text, way }) => [text, way?.label])).toEqual([
      ['The app closed before a.jpg, b.jpg were saved. Choose them again.', 'Choose photos'],
    ]);
  });
});

describe('a tab that closes', () => {
  it('asks while its last edit is neither saved nor in the journal, and not otherwise', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    expect(tab.asks()).toBe(false);
    await tab.add('a.jpg');
    expect(tab.asks()).toBe(false);
    rename(tab, 'Trip');
    expect([tab.keeping.status.value, tab.asks()]).toEqual(['saving', false]);
    vi.spyOn(browser.local, 'setItem').mockImplementation(() => {
      throw new Error('full');
    });
    rename(tab, 'Journey');
    expect(tab.asks()).toBe(true);
    await tab.keeping.flush();
    expect(tab.asks()).toBe(false);
    failing(() => Object.assign(new Error('no room'), { name: 'QuotaExceededError' }));
    rename(tab, 'Travels');
    await tab.keeping.flush();
    expect([tab.keeping.status.value, tab.asks()]).toEqual(['full', true]);
  });
});

describe('a film', () => {
  /** Delivers its frames one by one, up to a number. */
  function films(tab: Tab, most: number) {
    tab.engine.importVideo = async (file: File, { ids, onAbout, onPhoto }: any) => {
      onAbout({ duration: 24 });
      for (const [at, id] of ids.entries()) {
        if (at === most) await new Promise(() => {});
        onPhoto(id, await tab.engine.importPhoto(id, new File([`${file.name} ${at}`], file.name)), at);
      }
    };
  }

  it('whose frames were still being taken when the page was loaded again has all of them after', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    films(before, 5);
    const film = new File(['film'], 'film.mp4', { type: 'video/mp4' });
    void before.reading.addFiles([film]);
    await vi.waitFor(() => expect(before.store.reading.value?.done).toBe(5));
    await before.keeping.flush();
    expect([before.keeping.status.value, before.asks()]).toEqual(['saved', false]);
    const later = browser.died();
    const { tab: open } = later;
    const after = await open({ prepare: (tab) => films(tab, Infinity) });
    await vi.waitFor(() => expect(after.store.reading.value).toBe(null));
    expect([after.names().length, absent(after), after.store.facts.value.every(({ video }) => video)]).toEqual([
      24,
      [],
      true,
    ]);
    expect([...after.store.videos.value.values()].map(({ name, ids }) => [name, ids.length])).toEqual([
      ['film.mp4', 24],
    ]);
  });

  it('that is gone leaves its frames, and is named', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    films(before, Infinity);
    await before.reading.addFiles([new File(['film'], 'film.mp4', { type: 'video/mp4' })]);
    await before.keeping.flush();
    const base = await openDatabase();
    const [key] = (await base.getAllKeys('photos')).filter((id) => id.startsWith('file-'));
    await base.delete('photos', key);
    const after = await browser.died().tab();
    expect([after.names().length, absent(after), after.store.videos.value.size]).toEqual([24, [], 0]);
    expect(after.messages.list.value.map(({ text }) => text)).toEqual([
      'film.mp4 is no longer in this browser, but the frames are. To use other frames, add the video again.',
    ]);
  });
});
