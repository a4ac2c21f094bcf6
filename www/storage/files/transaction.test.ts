import { effect } from '@preact/signals';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { save as saveFile } from '../../ui/files.ts';
import { archiveOf, readArchive } from '../../engine/archive.ts';
import { openDatabase } from '../database.ts';
import { documentOf, fakeBrowser, historyIn } from '../testing.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));

let tab: Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;
/** A saved project of two photos. */
let file: File;

beforeEach(async () => {
  vi.mocked(saveFile).mockClear();
  tab = await fakeBrowser().tab();
  const { planner } = tab.store;
  const { choose } = planner.peek() as any;
  // The core accepts only whole numbers.
  Object.assign(planner.peek() as any, {
    choose: (photos: any[], threshold: number) => {
      if (!Number.isInteger(threshold))
        throw Object.assign(new Error('threshold: is no whole number'), { code: 'invalid-request' });
      return choose(photos, threshold);
    },
  });
  await tab.add('a.jpg', 'b.jpg');
  tab.store.change({ type: 'rename', name: 'Trip' });
  tab.pages.shuffle('all');
  await tab.keeping.flush();
  await tab.keeping.files.save();
  const [blob, name] = vi.mocked(saveFile).mock.calls[0];
  file = new File([blob], name);
});

/** The file with another document. */
async function changed(change: (present: any) => void) {
  const found = await readArchive(file);
  const entries = await Promise.all(
    [...found.values()].map(async ({ name, read }) => {
      const blob = await read();
      if (name !== 'project.json') return { name, blob };
      const json = JSON.parse(await blob.text());
      change(json.history.present);
      return { name, blob: new Blob([JSON.stringify(json)]) };
    }),
  );
  return new File([await archiveOf(entries)], 'other.inkpanel');
}

/** All that there is of the open project, on the page and in the database. */
async function everything() {
  const base = await openDatabase();
  const [projects, states] = await Promise.all([base.getAll('projects'), base.getAll('states')]);
  const [facts, photos] = await Promise.all([base.getAllKeys('facts'), base.getAllKeys('photos')]);
  base.close();
  const { store, keeping, photos: engine } = tab;
  const album = [...store.album.value.keys()];
  return structuredClone({
    document: documentOf(tab),
    album,
    engine: album.map(engine.has),
    place: keeping.current.value,
    status: keeping.status.value,
    safe: keeping.isSafe(),
    projects,
    states,
    facts,
    photos,
  });
}

const alerts = () => tab.messages.list.value.filter(({ kind }) => kind === 'alert').map(({ text }) => text);
/** Computes the state of the views after each change. */
const watch = () => effect(() => void tab.store.photos.value);

describe('a project that fails to open', () => {
  it('for a number that the core does not take leaves all as it was, in the database too', async () => {
    watch();
    const before = await everything();
    await tab.keeping.files.open(
      await changed((present) => {
        present.alike = 10.5;
      }),
    );
    await tab.keeping.flush();
    expect(alerts()).toEqual([expect.stringContaining('other.inkpanel could not be opened')]);
    expect(await everything()).toEqual(before);
  });

  it('when it is on the page already is taken back, and the next change is saved where it belongs', async () => {
    const before = await everything();
    let shown = 0;
    effect(() => {
      if (tab.store.project.value.name !== 'Trap') return;
      shown += 1;
      throw new Error('a view that cannot draw it');
    });
    await tab.keeping.files.open(
      await changed((present) => {
        present.name = 'Trap';
      }),
    );
    await tab.keeping.flush();
    expect([shown, alerts().length]).toEqual([1, 1]);
    expect(await everything()).toEqual(before);
    tab.pages.undo();
    tab.store.change({ type: 'rename', name: 'Journey' });
    await tab.keeping.flush();
    const after = await everything();
    expect(after.projects.map(({ id, name }) => [id, name])).toEqual([[before.place, 'Journey']]);
    expect(historyIn(after.states[0]).past).toEqual(before.document.past);
  });

  it('while what is open is not saved yet leaves that to be saved', async () => {
    watch();
    tab.store.change({ type: 'rename', name: 'Later' });
    await tab.keeping.files.open(
      await changed((present) => {
        present.alike = 10.5;
      }),
    );
    await tab.keeping.flush();
    expect((await everything()).projects.map(({ name }) => name)).toEqual(['Later']);
  });

  it('lets go of its lock and of the photos that it brought', async () => {
    watch();
    const held = [...tab.store.album.value.keys()];
    const added = vi.spyOn(tab.photos, 'add');
    await tab.keeping.files.open(
      await changed((present) => {
        present.alike = 10.5;
      }),
    );
    expect(held.every(tab.photos.has)).toBe(true);
    expect(added.mock.calls.some(([id]) => tab.photos.has(id))).toBe(false);
  });
});

describe('a save', () => {
  it('goes to the place that its history belongs to, whatever comes onto the page while it is on its way', async () => {
    const put = vi.spyOn(IDBObjectStore.prototype as any, 'put');
    tab.store.change({ type: 'rename', name: 'First' });
    const saving = tab.keeping.flush();
    const first = tab.keeping.current.value;
    tab.store.load({
      editing: tab.store.editing(),
      album: new Map(),
      videos: new Map(),
      place: { id: 'second', created: 0, stamp: '' },
    });
    await saving;
    await tab.keeping.flush();
    const written = put.mock.calls.map(([record]) => record).filter((record: any) => record.bytes);
    expect(written.map(({ id, facts }: any) => [id, facts.length])).toEqual([
      [first, 2],
      ['second', 0],
    ]);
    put.mockRestore();
  });
});
