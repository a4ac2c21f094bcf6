import { describe, expect, test, vi } from 'vitest';
import { unreadMeta } from '../document/album.ts';
import { foldersOf, noteFolders } from './folders.ts';
import { fakeApp, orderByName } from '../document/testing.ts';

vi.useFakeTimers();

const names = ({ store }: ReturnType<typeof fakeApp>) =>
  (store.page.value?.panels ?? []).map(({ photo }) => store.album.value.get(String(photo))?.name);
const alerts = ({ messages }: ReturnType<typeof fakeApp>) => messages.list.value.map(({ text }) => text);
/** The message about a file that is damaged or not an image. */
const notAnImage = (name: string) =>
  expect.stringMatching(new RegExp(`^${name}: the file is damaged, or not an image in`));

describe('the first photos', () => {
  test('are laid out before any is read, in the order of their names', async () => {
    const app = fakeApp();
    orderByName(app);
    /** The state after the first photo was read. */
    let first: unknown = null;
    app.store.reading.subscribe((reading) => {
      if (reading?.done === 1) first ??= names(app);
    });
    await app.reading.addFiles(app.files('p10.jpg', 'p2.jpg', 'p1.jpg'));
    expect(first).toEqual(['p1.jpg', 'p2.jpg', 'p10.jpg']);
    expect(app.store.reading.value).toBe(null);
    expect(names(app)).toEqual(['p1.jpg', 'p2.jpg', 'p10.jpg']);
  });

  test('of folders keep the order of their folders', async () => {
    const app = fakeApp();
    orderByName(app);
    const files = ['ch10/001.jpg', 'ch2/002.jpg', 'ch2/001.jpg', 'cover.jpg'].map((path) => {
      const [name, folder] = path.split('/').reverse();
      return noteFolders(new File(['x'], name), folder ? [folder] : []);
    });
    await app.reading.addFiles(files);
    const places = app.store.tray.value.map(({ id }) => {
      const file = app.engine.files.get(id);
      return [...foldersOf(file), file.name].join('/');
    });
    expect(places).toEqual(['ch2/001.jpg', 'ch2/002.jpg', 'ch10/001.jpg', 'cover.jpg']);
  });

  test('are no near-duplicates of each other before they are read', () => {
    for (const prefix of ['p', 'p0.5514308192382507-']) {
      const prints = Array.from({ length: 120 }, (_, i) => BigInt(`0x${unreadMeta(`${prefix}${i + 1}`).fingerprint}`));
      const bits = (value: bigint) => value.toString(2).replaceAll('0', '').length;
      const distances = prints.flatMap((one, i) => prints.slice(0, i).map((other) => bits(one ^ other)));
      // The core sets photos aside that differ in 10 bits or fewer.
      expect(Math.min(...distances)).toBeGreaterThan(10);
    }
  });

  test('cannot be undone: there is nothing before them', async () => {
    const app = fakeApp();
    await app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
    expect(app.store.mirror.value.undos).toBe(0);
    expect(app.store.mirror.value.shown.length).toBe(1);
  });

  test('that cannot be read are named; the others become the page', async () => {
    const app = fakeApp({ 'b.txt': 'bad' });
    await app.reading.addFiles(app.files('a.jpg', 'b.txt', 'c.jpg'));
    await vi.advanceTimersByTimeAsync(1_000);
    expect(alerts(app)).toEqual([notAnImage('b.txt')]);
    expect(names(app)).toEqual(['a.jpg', 'c.jpg']);
    expect(app.store.tray.value.length).toBe(2);
  });

  test('that are damaged are named with the share that is missing, once', async () => {
    const app = fakeApp({ 'a.jpg': 'damaged', 'b.jpg': 'coarse' });
    await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg'));
    const told = [
      'a.jpg: 12% of the photo is damaged and shown in grey.',
      'b.jpg: 1% of the photo lacks detail, because the file is damaged or incomplete.',
    ];
    await vi.advanceTimersByTimeAsync(1_000);
    expect(app.messages.failures.value.map(({ text }) => text)).toEqual(told);
    expect(alerts(app)).toEqual(['2 files are damaged; their readable parts are used.']);
    expect(app.store.facts.value.every(({ meta }) => meta && !('damage' in meta))).toBe(true);
    const [file] = app.files('a.jpg');
    app.messages.list.value.forEach(({ id }) => app.messages.close(id));
    await app.reading.resume([{ id: 'p1', file }]);
    expect(alerts(app)).toEqual([]);
  });

  test('that are all bad leave nothing but the word of it', async () => {
    const app = fakeApp({ 'a.txt': 'bad', 'b.txt': 'bad' });
    await app.reading.addFiles(app.files('a.txt', 'b.txt'));
    expect(app.store.tray.value).toEqual([]);
    expect(app.store.page.value).toBe(null);
    await vi.advanceTimersByTimeAsync(1_000);
    expect(alerts(app)).toEqual([expect.stringContaining('None of these files')]);
    expect(app.messages.failures.value.map(({ text }) => text)).toEqual([notAnImage('a.txt'), notAnImage('b.txt')]);
    expect(app.store.mirror.value.shown).toEqual([]);
    await app.reading.addFiles(app.files('good.jpg'));
    expect(alerts(app)).toEqual(['2 files could not be read.']);
    expect(app.store.mirror.value.shown.length).toBe(1);
  });

  test('are released if another project is open when they arrive', async () => {
    const app = fakeApp();
    const read: (() => void)[] = [];
    const forgotten: string[] = [];
    app.engine.importDraft = async (id: string) => {
      await new Promise<void>((resolve) => read.push(resolve));
      return id === 'p1' ? { ...unreadMeta(id), measures: {} } : null;
    };
    app.engine.forgetPhoto = (id: string) => forgotten.push(id);
    const done = app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
    await vi.advanceTimersByTimeAsync(100);
    app.store.unknow(['p1', 'p2']);
    for (const go of read) go();
    await vi.advanceTimersByTimeAsync(1_000);
    await done;
    // The draft, and then both photos.
    expect(forgotten).toEqual(['p1', 'p1', 'p2']);
    expect(app.store.album.value.size).toBe(0);
  });

  test('are shown as drafts, which the photos replace', async () => {
    const app = fakeApp({ 'b.jpg': 'bad', 'c.jpg': 'damaged' });
    let read = () => {};
    const arrived = new Promise<void>((resolve) => {
      read = resolve;
    });
    const { importPhoto } = app.engine;
    const signals: unknown[] = [];
    app.engine.importDraft = async (id: string) => ({ ...unreadMeta(id), measures: { draft: 1 } });
    app.engine.importPhoto = async (id: string, file: File, { signal }: any) => {
      signals.push(signal);
      await arrived;
      return importPhoto(id, file);
    };
    const forgotten: string[] = [];
    app.engine.forgetPhoto = (id: string) => forgotten.push(id);
    const done = app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg'));
    await vi.advanceTimersByTimeAsync(1_000);
    expect(app.store.sketch.value).toBe(false);
    expect(app.store.reading.value).toEqual({ done: 0, total: 3 });
    expect(app.store.album.value.get('p1')?.measures).toEqual({ draft: 1 });
    // Photos that the user sees are read in any case.
    app.reading.cancel();
    read();
    await vi.advanceTimersByTimeAsync(1_000);
    await done;
    expect(signals).toEqual([undefined, undefined, undefined]);
    expect(app.store.album.value.get('p1')?.measures).toEqual({ twin: 0 });
    // A draft does not hide that its photo cannot be read or is damaged.
    expect(forgotten).toEqual(['p2']);
    expect(names(app).sort()).toEqual(['a.jpg', 'c.jpg']);
    const told = app.messages.failures.value.map(({ text }) => text);
    expect(told).toEqual([notAnImage('b.jpg'), expect.stringContaining('c.jpg: 12%')]);
    expect(alerts(app)).toEqual(['1 file could not be read. 1 file is damaged; its readable part is used.']);
  });

  test('that look like another are set aside', async () => {
    const app = fakeApp({ 'c.jpg': 'twin' });
    await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg'));
    expect(names(app)).toEqual(['a.jpg', 'b.jpg']);
    expect(app.store.verdicts.value.get('p3')).toMatchObject({ kept: false, reason: { code: 'same-as' } });
  });
});

test('of hundreds those that are not on the page are told of together, and all are known at the end', async () => {
  const app = fakeApp();
  // The first photos are on the page and reported immediately.
  app.planner.planned = (page) => ({
    ...page,
    panels: page.panels.map((panel, i) => ({ ...panel, photo: `p${i + 1}`, crop: null })),
  });
  let changes = -1;
  app.store.album.subscribe(() => {
    changes += 1;
  });
  const done = app.reading.addFiles(app.files(...Array.from({ length: 200 }, (_, i) => `${i}.jpg`)));
  await vi.advanceTimersByTimeAsync(250);
  const early = app.store.facts.value.filter(({ meta }) => meta).length;
  expect(early).toBeLessThan(20);
  await vi.advanceTimersByTimeAsync(400);
  await done;
  expect(app.store.facts.value.filter(({ meta }) => meta).length).toBe(200);
  expect(app.store.reading.value).toBe(null);
  expect(changes).toBeLessThan(40);
});

describe('photos added later', () => {
  test('join the page as one step', async () => {
    const app = fakeApp();
    orderByName(app);
    await app.reading.addFiles(app.files('a.jpg'));
    const before = app.store.page.value;
    await app.reading.addFiles(app.files('b.jpg', 'c.jpg'));
    expect(names(app)).toEqual(['a.jpg', 'b.jpg', 'c.jpg']);
    expect(app.store.page.value?.panels.length).toBe(3);
    app.pages.undo();
    expect(app.store.page.value).toBe(before);
    expect(app.store.tray.value.length).toBe(1);
  });

  test('that are all bad change nothing', async () => {
    const app = fakeApp({ 'b.txt': 'bad' });
    await app.reading.addFiles(app.files('a.jpg'));
    const { page, mirror } = app.store;
    const before = page.value;
    await app.reading.addFiles(app.files('b.txt'));
    expect(page.value).toBe(before);
    expect(mirror.value.undos).toBe(0);
  });
});

describe('the tray', () => {
  test('a photo that is not used any more leaves the page, as one step', async () => {
    const app = fakeApp();
    orderByName(app);
    await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg'));
    app.reading.use('p2', false);
    expect(names(app)).toEqual(['a.jpg', 'c.jpg']);
    app.pages.undo();
    expect(names(app)).toEqual(['a.jpg', 'b.jpg', 'c.jpg']);
    expect(app.store.mirror.value.undos).toBe(0);
  });

  test('without a photo in use there is no page, and the tray stays', async () => {
    const app = fakeApp();
    await app.reading.addFiles(app.files('a.jpg'));
    app.reading.use('p1', false);
    expect(app.store.page.value).toBe(null);
    expect(app.store.tray.value.length).toBe(1);
    app.reading.use('p1', true);
    expect(names(app)).toEqual(['a.jpg']);
  });
});

test('a photo that is given an empty place leaves no trace in another project that was opened meanwhile', async () => {
  const app = fakeApp();
  await app.reading.addFiles(app.files('b.jpg'));
  const { store, reading, engine } = app;
  const [id] = reading.freshIds(1);
  store.know({ id, name: 'a.jpg', meta: unreadMeta(id), measures: null });
  let calls = 0;
  engine.importPhoto = async (which: string) => {
    calls += 1;
    if (calls === 1) throw Object.assign(new Error('damaged'), { code: 'damaged' });
    // The empty place is read while the other project comes.
    store.album.value = new Map([...store.album.peek()].filter(([other]) => other !== id));
    return { ...unreadMeta(which), measures: {} };
  };
  await reading.resume([{ id, file: app.files('a.jpg')[0] }]);
  await vi.advanceTimersByTimeAsync(1000);
  expect(calls).toBe(2);
  expect(store.album.value.has(id)).toBe(false);
});
