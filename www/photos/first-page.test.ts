import { describe, expect, test, vi } from 'vitest';
import { edited, fakeApp, orderByName, pageOf } from '../document/testing.ts';

vi.useFakeTimers();

/**
 * @param slow files that are never finished
 * @param detects whether faces are detected
 */
function app(slow: (name: string) => boolean, odd: Parameters<typeof fakeApp>[0] = {}, detects = false) {
  const made = fakeApp(odd, {}, detects);
  const go: (() => void)[] = [];
  // The first files are on the sketch.
  made.planner.planned = (page, { keep }) =>
    keep && !keep.photos
      ? { ...page, panels: page.panels.map((panel, i) => ({ ...panel, photo: `p${i + 1}`, crop: null })) }
      : page;
  const { importPhoto } = made.engine;
  made.engine.importPhoto = async (id: string, file: File) => {
    if (slow(file.name)) await new Promise<void>((done) => go.push(done));
    return importPhoto(id, file);
  };
  const names = () => made.store.page.value?.panels.map(({ photo }) => made.store.album.value.get(String(photo))?.name);
  return { ...made, names, release: () => go.splice(0).forEach((done) => done()) };
}

/** Has each of the ten take 100 ms longer than the one before. */
function readInTurn(engine: ReturnType<typeof app>['engine']) {
  const { importPhoto } = engine;
  engine.importPhoto = async (id: string, file: File) => {
    await new Promise((done) => setTimeout(done, 100 * (1 + Number.parseInt(file.name, 10))));
    return importPhoto(id, file);
  };
}

const ten = Array.from({ length: 10 }, (_, i) => `${i}.jpg`);

describe('the first page', () => {
  test('is a sketch until its photos are read, then planned on those that are', async () => {
    const { store, reading, files, names, planner } = app((name) => Number.parseInt(name, 10) >= 7, {
      '1.jpg': 'twin',
    });
    orderByName({ store });
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(100);
    expect(store.sketch.value).toBe(true);
    await vi.advanceTimersByTimeAsync(500);
    expect(store.sketch.value).toBe(false);
    expect(names()).toEqual(['0.jpg', '2.jpg', '3.jpg', '4.jpg', '5.jpg', '6.jpg']);
    expect(planner.wishes.at(-1)).toMatchObject({ type: 'compose', photos: { length: 6 }, panels: 6 });
    expect(store.mirror.value.undos).toBe(0);
    expect(store.mirror.value.shown.length).toBe(1);
  });

  test('has a sketch for the sizes in the headers of its photos', async () => {
    const { store, reading } = app(() => true);
    // The header of a portrait: 900 by 1600 pixels.
    const head = Uint8Array.from([0xff, 0xd8, 0xff, 0xc0, 0, 8, 8, 6, 64, 3, 132, 3]);
    void reading.addFiles(ten.map((name) => new File([head], name)));
    await vi.advanceTimersByTimeAsync(50);
    expect(store.sketch.value).toBe(true);
    expect(store.photos.value.map(({ width, height }) => `${width}x${height}`)).toEqual(ten.map(() => '900x1600'));
  });

  test('keeps the layout of its sketch', async () => {
    const { store, reading, files, planner, release } = app(() => true);
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(50);
    expect(store.sketch.value).toBe(true);
    const layout = store.page.value?.layout;
    release();
    await vi.advanceTimersByTimeAsync(700);
    expect(store.sketch.value).toBe(false);
    expect(planner.wishes.at(-1)).toMatchObject({ type: 'compose', layout });
    expect(store.page.value?.layout).toEqual(layout);
  });

  test('waits no longer than until faces were looked for in its photos', async () => {
    const { store, reading, files, engine } = app(() => false);
    readInTurn(engine);
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(610);
    const read = store.facts.value.filter(({ meta }) => meta !== null).map(({ id }) => id);
    expect(read.length).toBe(6);
    store.faced.value = new Set(read.slice(1));
    await vi.advanceTimersByTimeAsync(5);
    expect(store.sketch.value).toBe(true);
    store.faced.value = new Set(read);
    await vi.advanceTimersByTimeAsync(5);
    expect(store.sketch.value).toBe(false);
  });

  test('of a video waits longer for faces', async () => {
    const { store, reading, files, engine } = app(() => false, {}, true);
    readInTurn(engine);
    void reading.addFiles(files(...ten));
    const know = () => store.facts.value.forEach((fact) => store.know({ ...fact, video: 'film' }));
    await vi.advanceTimersByTimeAsync(550);
    know();
    await vi.advanceTimersByTimeAsync(300);
    expect(store.sketch.value).toBe(true);
  });

  test('waits for more photos instead of pages of text', async () => {
    const { store, reading, files, engine, planner } = app(() => false);
    const { createEditor } = planner;
    planner.createEditor = () => {
      const editor = createEditor();
      const isText = (id: string) => ['1.jpg', '2.jpg'].includes(store.album.value.get(id)?.name ?? '');
      const unseen = (photos: readonly { id: string }[]) =>
        photos.map(({ id }) => ({ photo: id, why: isText(id) ? ('text' as const) : ('waits' as const) }));
      return { ...editor, plans: (photos) => ({ ...editor.plans(photos), unseen: () => unseen(photos) }) };
    };
    readInTurn(engine);
    void reading.addFiles(files(...Array.from({ length: 20 }, (_, i) => `${i}.jpg`)));
    await vi.advanceTimersByTimeAsync(790);
    expect(store.sketch.value).toBe(true);
    await vi.advanceTimersByTimeAsync(150);
    expect(store.sketch.value).toBe(false);
    expect(store.reading.value?.done).toBe(9);
  });

  test('is near while its photos are read, but not where another must take the place of one', async () => {
    const { store, reading, files, release } = app((name) => ['0.jpg', '7.jpg', '8.jpg', '9.jpg'].includes(name), {
      '0.jpg': 'bad',
      '1.jpg': 'bad',
    });
    const done = reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(50);
    // The unfinished photo is on the sketch.
    expect([store.sketch.value, reading.near.value]).toEqual([true, true]);
    release();
    await done;
    await vi.advanceTimersByTimeAsync(700);
    expect([store.sketch.value, reading.near.value, store.tray.value.length]).toEqual([false, false, 8]);
  });

  test('lets the others be read where photos of it turn out to be none', async () => {
    const { store, reading, files, release } = app((name) => Number.parseInt(name, 10) >= 6, { '0.jpg': 'bad' });
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(50);
    expect([store.sketch.value, reading.near.value]).toEqual([true, false]);
    release();
    await vi.advanceTimersByTimeAsync(700);
    expect([store.sketch.value, store.tray.value.length]).toEqual([false, 9]);
  });

  test('does not wait for others that take long to read', async () => {
    const { store, reading, files, engine } = app(() => false);
    readInTurn(engine);
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(650);
    expect([store.sketch.value, reading.near.value]).toEqual([true, true]);
    await vi.advanceTimersByTimeAsync(100);
    expect([store.sketch.value, store.reading.value?.done]).toEqual([false, 7]);
  });

  test('does not change by what is read after it', async () => {
    const { store, reading, files, names, release } = app((name) => Number.parseInt(name, 10) >= 7);
    const done = reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(700);
    const before = names();
    release();
    await done;
    expect(store.reading.value).toBeNull();
    expect(names()).toEqual(before);
  });

  test('stays in use where a look-alike turns up later', async () => {
    const { store, reading, files, names, release, pages } = app((name) => Number.parseInt(name, 10) >= 7);
    const done = reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(700);
    store.planner.value = {
      ...store.planner.value,
      choose: (photos: { id: string; name: string }[]) =>
        photos.map(({ id, name }) => ({
          id,
          group: name === '2.jpg' || name === '9.jpg' ? 2 : Number(id.slice(1)) + 10,
          kept: name !== '2.jpg',
          reason: { code: 'only' },
        })),
    } as unknown as typeof store.planner.value;
    const before = names();
    expect(before).toContain('2.jpg');
    release();
    await done;
    pages.refine();
    expect(names()).toEqual(before);
    expect(store.photos.value.map(({ id }) => store.album.value.get(id)?.name)).not.toContain('9.jpg');
  });

  test('is no longer waited for by who shuffles', async () => {
    const { store, reading, files, pages } = app((name) => name !== '0.jpg');
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(50);
    expect(store.sketch.value).toBe(true);
    pages.shuffle('all');
    expect(store.sketch.value).toBe(false);
    const page = store.page.value;
    await vi.advanceTimersByTimeAsync(1000);
    expect(store.page.value?.layout).toBe(page?.layout);
  });

  test('is not drawn over another project, whose pages have the same ids', async () => {
    const { store, reading, files } = app((name) => name !== '0.jpg');
    void reading.addFiles(files(...ten));
    await vi.advanceTimersByTimeAsync(50);
    expect(store.sketch.value).toBe(true);
    const editing = edited({ type: 'show-page', page: pageOf(77), pageId: 1 });
    expect(editing.mirror().present.pageId).toBe(store.project.value.pageId);
    const place = { ...store.place.value, id: 'another' };
    store.load({ editing, album: new Map(), videos: new Map(), place });
    await vi.advanceTimersByTimeAsync(1000);
    expect(store.sketch.value).toBe(false);
    expect(store.page.value?.seed).toBe(77);
  });
});
