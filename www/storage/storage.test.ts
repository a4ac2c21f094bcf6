import { describe, expect, it, vi } from 'vitest';
import { Editor } from '../pkg/inkpanel.js';
import { openDatabase } from './database.ts';
import { createEditing } from '../document/editing.ts';
import { core } from '../engine/testing-core.ts';
import { createDrawnStates, drawnId } from './drawn-states.ts';
import { createLocks } from './locks.ts';
import { sweep } from './sweeping.ts';
import { documentOf, fakeBrowser } from './testing.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

describe('after the page is loaded again', () => {
  it('all is there, undo too, and no photo is decoded', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg', 'c.jpg');
    for (let i = 0; i < 220; i += 1) before.pages.shuffle('all');
    before.pages.undo();
    before.store.change({ type: 'rename', name: 'Trip' });
    before.store.change({ type: 'love-page', pageId: 2, on: true });
    await before.keeping.flush();
    expect(before.keeping.status.value).toBe('saved');

    const after = await browser.tab();
    // The first tab still has it.
    expect(after.keeping.elsewhere.value?.name).toBe('Trip');
    await before.keeping.create();
    await vi.waitFor(() => expect(after.names()).toEqual(['a.jpg', 'b.jpg', 'c.jpg']));
    expect(after.decoded).toEqual([]);
    expect(after.store.project.value.loved).toEqual([2]);
    expect(after.photos.get(after.store.tray.value[0].id).work.planes.size).toBe('work of a.jpg'.length);
    for (let i = 0; i < 200; i += 1) after.pages.undo();
    expect(after.store.mirror.value.redos).toBe(200);
  });

  it('the document is as it was, whatever is in it', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const page = { ...before.store.page.value, words: [{ kind: 'effect', text: 'Boom', x: 0.2, y: 0.3 }] } as any;
    before.store.change({ type: 'change-page', page });
    await before.keeping.flush();
    const wanted = documentOf(before);
    const after = await browser.tab();
    await before.keeping.create();
    await vi.waitFor(() => expect(documentOf(after)).toEqual(wanted));
    expect((after.store.page.value as any).words[0].text).toBe('Boom');
  });

  it('the history is read once', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const [{ id }] = before.store.tray.value;
    const load = vi.spyOn(Editor.prototype, 'load');
    const after = await browser.died().tab();
    expect(after.names()).toEqual(['a.jpg', 'b.jpg']);
    const read = load.mock.calls.filter(([bytes]) => new TextDecoder().decode(bytes as any).includes(id));
    expect(read).toHaveLength(1);
    load.mockRestore();
  });

  it('photos that are chosen before the project is there join it', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const dead = fakeBrowser(browser);
    let added: Promise<void> | null = null;
    const after = await dead.tab({
      session: before.session,
      early: ({ keeping, reading }) => {
        added = keeping.turned().then(() => reading.addFiles(before.files('c.jpg')));
      },
    });
    await added;
    expect(after.names()).toEqual(['a.jpg', 'b.jpg', 'c.jpg']);
    expect(after.keeping.list.value).toHaveLength(1);
  });

  it('photos that were still being read are read again', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg');
    const { importPhoto } = before.engine;
    before.engine.importPhoto = () => new Promise(() => {});
    void before.reading.addFiles(before.files('b.jpg'));
    await vi.waitFor(() => expect(before.store.originals.size).toBe(1));
    await before.keeping.flush();
    before.engine.importPhoto = importPhoto;
    // The tab crashes, and its lock is released.
    const dead = fakeBrowser(browser);
    const after = await dead.tab();
    await vi.waitFor(() => expect(after.names()).toEqual(['a.jpg', 'b.jpg']));
    await vi.waitFor(() => expect(after.decoded).toEqual(['b.jpg']));
  });
});

describe('the last states that were drawn', () => {
  it('are written with the project, three of them, and their photos are kept', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg', 'b.jpg');
    const base = await openDatabase();
    const [project] = await base.getAll('projects');
    const kept = async () =>
      ((await base.get('states', drawnId(project.id))) as any)?.drawn.map(({ name }: any) => name);
    expect(await kept()).toBe(undefined);
    for (const name of ['One', 'Two', 'Three', 'Four', 'Five']) {
      tab.store.change({ type: 'rename', name, silent: true });
      // States that were not drawn are not stored.
      if (name !== 'Three' && name !== 'Five') tab.keeping.drawn();
      await tab.keeping.flush();
    }
    expect(await kept()).toEqual(['One', 'Two', 'Four']);
    tab.store.change({ type: 'forget-photos', ids: tab.store.tray.value.map(({ id }) => id) });
    await tab.keeping.flush();
    expect((await base.getAll('projects'))[0].refs).toEqual(project.refs);
  });

  it('include a restored state once', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg', 'b.jpg');
    const states = createDrawnStates({ store: tab.store });
    const place = tab.store.place.value;
    states.note();
    expect(states.of(place)).toEqual([tab.store.project.value]);
    tab.store.load({
      editing: createEditing(core.createEditor(), tab.store.mirror.value),
      album: tab.store.album.value,
      videos: new Map(),
    });
    states.note();
    expect(states.of(place)).toEqual([tab.store.project.value]);
  });

  it('have no photo that is still being read: it may turn out to be none', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg', 'b.jpg');
    tab.keeping.drawn();
    await tab.keeping.flush();
    const base = await openDatabase();
    const [{ id, refs }] = await base.getAll('projects');
    let refuse = (_error: Error) => {};
    tab.engine.importPhoto = () =>
      new Promise((_resolve, reject) => {
        refuse = reject;
      });
    const adding = tab.reading.addFiles(tab.files('no-photo.png'));
    await vi.waitFor(() => expect(tab.store.tray.value.length).toBe(3));
    tab.keeping.drawn();
    await tab.keeping.flush();
    refuse(new Error('no photo'));
    await adding;
    await tab.keeping.flush();
    expect((await base.get('projects', id))?.refs).toEqual(refs);
    expect(((await base.get('states', drawnId(id))) as any).drawn.map(({ tray }: any) => tray.length)).toEqual([2]);
  });
});

describe('projects', () => {
  it('are made, opened, copied, deleted and brought back', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg');
    tab.store.change({ type: 'rename', name: 'One' });
    await tab.keeping.create();
    await tab.add('b.jpg', 'c.jpg');
    tab.store.change({ type: 'rename', name: 'Two' });
    await tab.keeping.flush();
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.map(({ name, photos }) => [name, photos])).toEqual([
      ['Two', 2],
      ['One', 1],
    ]);
    const one = tab.keeping.list.value[1].id;
    expect(await tab.keeping.open(one)).toBe(true);
    expect([tab.names(), tab.store.project.value.name]).toEqual([['a.jpg'], 'One']);
    const copy = await tab.keeping.duplicate(one);
    expect(tab.keeping.list.value.map(({ name }) => name)).toContain('One copy');
    await tab.keeping.open(copy as string);
    expect(tab.names()).toEqual(['a.jpg']);
    await tab.keeping.remove(copy as string);
    expect([tab.names(), tab.keeping.list.value.length]).toEqual([[], 2]);
    // It stays until it is closed.
    expect(tab.messages.list.value[0].kind).toBe('offer');
    tab.messages.list.value[0].way?.run();
    await vi.waitFor(() => expect(tab.names()).toEqual(['a.jpg']));
    expect(tab.keeping.list.value.length).toBe(3);
  });

  it('are open in one tab at a time; another gets a copy, or waits', async () => {
    const browser = fakeBrowser();
    const one = await browser.tab();
    await one.add('a.jpg');
    const two = await browser.tab();
    expect([two.names(), two.keeping.elsewhere.value?.follows]).toEqual([[], true]);
    await two.keeping.openCopy();
    expect(two.names()).toEqual(['a.jpg']);
    await two.add('b.jpg');
    await one.add('c.jpg');
    expect([one.names(), two.names()]).toEqual([
      ['a.jpg', 'c.jpg'],
      ['a.jpg', 'b.jpg'],
    ]);
    expect(one.keeping.current.value).not.toBe(two.keeping.current.value);
    expect([one.keeping.status.value, two.keeping.status.value]).toEqual(['saved', 'saved']);
  });

  it('go on as a copy when somebody else has written, lock or no lock', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg');
    const base = await openDatabase();
    const [project] = await base.getAll('projects');
    await base.put('projects', { ...project, stamp: 'other' });
    tab.store.change({ type: 'rename', name: 'Mine' });
    await tab.keeping.flush();
    tab.store.change({ type: 'lock', part: 'style', on: true });
    await tab.keeping.flush();
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.map(({ name }) => name).sort()).toEqual(['', 'Mine copy']);
  });

  it('leave nothing behind a day after they were deleted', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    await tab.add('a.jpg');
    await tab.keeping.create();
    await tab.add('b.jpg');
    await tab.keeping.refresh();
    await tab.keeping.remove(tab.keeping.list.value[1].id);
    const base = await openDatabase();
    const locks = createLocks(browser.locks as any);
    await sweep(base, locks);
    expect([await base.count('projects'), await base.count('photos')]).toEqual([2, 2]);
    await sweep(base, locks, Date.now() + 25 * 3600 * 1000);
    expect([
      await base.count('projects'),
      await base.count('states'),
      await base.count('photos'),
      await base.count('facts'),
    ]).toEqual([1, 1, 1, 1]);
    expect((await base.getAll('photos')).map(({ name }) => name)).toEqual(['b.jpg']);
  });
});
