import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import { createSubjects } from './subjects.ts';
import { fakeApp } from '../document/testing.ts';
import type { Store } from '../document/store.ts';
import type { Detection } from '../engine/types.ts';

const face = { label: 'face', score: 0.9, x: 0.1, y: 0.1, width: 0.2, height: 0.2 };

const dog = { label: 'dog', score: 0.8, x: 0.4, y: 0.4, width: 0.3, height: 0.3 };

/**
 * @param look for faces
 * @param found objects of every photo
 * @param search for objects
 */
function app(
  look: (id: string) => Promise<any>,
  found: any[] = [],
  window: any = undefined,
  search: (id: string) => Promise<any[]> = async () => found,
) {
  const made = fakeApp();
  const asked: string[] = [];
  const objects: string[] = [];
  const [painted, unsettled] = [signal(false), signal(false)];
  const nets = { asked: 0, ready: true };
  /** Ids of drafts. */
  const drafts = new Set<string>();
  const engine = {
    hasPhoto: () => true,
    isDraft: (id: string) => drafts.has(id),
    prepareDetectors: () => {
      nets.asked += 1;
    },
    facesReady: () => nets.ready,
    findFaces: async (id: string) => {
      asked.push(id);
      return look(id);
    },
    findMoreFaces: async (id: string, boxes: readonly Detection[], known: readonly Detection[]) => {
      expect(known).toEqual(found);
      asked.push(`${id} closer`);
      return [...boxes, face];
    },
    findObjects: async (id: string) => {
      objects.push(id);
      return search(id);
    },
  };
  const subjects = createSubjects({
    ...made,
    engine,
    painted: () => painted.value,
    unsettled: () => unsettled.value,
    onFound: made.pages.refine,
    window,
  });
  return { ...made, subjects, painted, unsettled, asked, objects, nets, drafts };
}

const settle = () =>
  new Promise((done) => {
    setTimeout(done, 10);
  });

/** Fills every panel with one photo. */
function showOnly(store: Store, photo: string) {
  const page = store.page.value as NonNullable<typeof store.page.value>;
  const panels = page.panels.map((panel) => ({ ...panel, photo }));
  store.change({ type: 'change-page', page: { ...page, panels }, silent: true });
}

describe('subjects', () => {
  it('looks for faces while photos are read, at all else once there is a page, closer after all others', async () => {
    const { reading, files, subjects, painted, asked, objects, store, planner } = app(async (id) => ({
      boxes: [face],
      closer: id === 'p1',
    }));
    await reading.addFiles(files('1.jpg', '2.jpg', '3.jpg'));
    await settle();
    expect(asked).not.toContain('p1 closer');
    expect(objects).toEqual([]);
    expect(subjects.settled.value).toBe(false);
    painted.value = true;
    await settle();
    expect(asked).toEqual(['p1', 'p2', 'p3', 'p1 closer']);
    expect(subjects.settled.value).toBe(true);
    expect(store.album.value.get('p1')?.meta?.subjects).toEqual([face, face]);
    expect(planner.used[1].subjects).toEqual([face]);
    expect(subjects.progress.value).toBeNull();
  });

  it('looks closer at photos of persons when their objects are known', async () => {
    const person = { label: 'person', score: 0.8, x: 0.4, y: 0.4, width: 0.3, height: 0.3 };
    const { reading, files, painted, asked, store } = app(async () => ({ boxes: [face], closer: false }), [person]);
    await reading.addFiles(files('1.jpg', '2.jpg'));
    painted.value = true;
    await vi.waitFor(() => expect(asked).toEqual(['p1', 'p2', 'p1 closer', 'p2 closer']));
    expect(store.album.value.get('p2')?.meta?.subjects).toEqual([face, face, person]);
    expect(store.album.value.get('p2')?.looked).toBe(true);
  });

  it.each([
    ['looks for faces on the visible page first while other photos are read', false],
    ['looks for no faces in frames of other pages while a video is read', true],
  ])('%s', async (_, isFilm) => {
    const { reading, files, painted, asked, objects, store } = app(async () => ({ boxes: [face], closer: false }));
    await reading.addFiles(files('1.jpg', '2.jpg', '3.jpg'));
    if (isFilm) for (const fact of store.facts.value) store.know({ ...fact, video: 'film' });
    store.sketch.value = false;
    showOnly(store, 'p3');
    asked.length = 0;
    store.reading.value = { done: 3, total: 90 };
    painted.value = true;
    await settle();
    expect([asked, objects]).toEqual([isFilm ? ['p3'] : ['p3', 'p2'], []]);
    expect(store.album.value.get('p2')?.meta?.subjects).toEqual(isFilm ? [] : [face]);
    store.reading.value = null;
    await settle();
    expect(asked).toEqual(['p3', 'p2']);
  });

  it('tells of faces off the page, and that all faces are known, before the objects', async () => {
    let answer: (objects: Detection[]) => void = () => {};
    const found = new Promise<Detection[]>((done) => {
      answer = done;
    });
    const look = async () => ({ boxes: [face], closer: false });
    const { reading, files, painted, store, subjects } = app(look, [], undefined, () => found);
    await reading.addFiles(files('1.jpg', '2.jpg', '3.jpg'));
    store.sketch.value = false;
    showOnly(store, 'p1');
    painted.value = true;
    await settle();
    expect(store.album.value.get('p3')?.meta?.subjects).toEqual([face]);
    expect([subjects.faced.value, subjects.searched.value]).toEqual([false, false]);
    answer([]);
    await settle();
    expect([subjects.faced.value, subjects.searched.value]).toEqual([true, true]);
  });

  it('looks at the photos of a page that appeared just now when the user rests', async () => {
    const { reading, files, painted, asked, objects, scheduler } = app(async () => ({ boxes: [], closer: false }));
    scheduler.hold(true);
    await reading.addFiles(files('1.jpg', '2.jpg', '3.jpg'));
    painted.value = true;
    await settle();
    expect(objects).toEqual([]);
    scheduler.hold(false);
    await vi.waitFor(() => expect(objects).toEqual(['p1', 'p2', 'p3']));
    expect(asked).toEqual(objects);
  });

  it('waits only a moment for a rest of the first page that may be planned again', async () => {
    const { reading, files, painted, unsettled, objects, scheduler } = app(async () => ({ boxes: [], closer: false }));
    scheduler.hold(true);
    unsettled.value = true;
    await reading.addFiles(files('1.jpg', '2.jpg'));
    painted.value = true;
    await settle();
    expect(objects).toEqual([]);
    await vi.waitFor(() => expect(objects).toEqual(['p1', 'p2']));
  });

  it('looks closer at photos off the page after the first look at all photos', async () => {
    const answers: (() => void)[] = [];
    const { reading, files, painted, asked, store, subjects } = app(
      async () => ({ boxes: [face], closer: true }),
      [],
      undefined,
      (id) => (id === 'p3' ? new Promise((done) => answers.push(() => done([]))) : Promise.resolve([])),
    );
    await reading.addFiles(files('1.jpg', '2.jpg', '3.jpg'));
    showOnly(store, 'p1');
    painted.value = true;
    await settle();
    expect(asked).toEqual(['p1', 'p2', 'p3', 'p1 closer']);
    answers.forEach((answer) => answer());
    await settle();
    expect(asked.slice(4)).toEqual(['p2 closer', 'p3 closer']);
    expect(subjects.settled.value).toBe(true);
  });

  it('looks for faces in drafts for the first page, and again in the photos that replace them', async () => {
    const { reading, files, asked, store, engine, drafts, painted } = app(async (id) => ({
      boxes: drafts.has(id) ? [face] : [face, dog],
      closer: false,
    }));
    const { importPhoto } = engine;
    engine.importDraft = async (id: string, file: File) => {
      drafts.add(id);
      return importPhoto(id, file);
    };
    let read = () => {};
    const arrived = new Promise<void>((resolve) => {
      read = resolve;
    });
    engine.importPhoto = async (id: string, file: File) => {
      await arrived;
      drafts.delete(id);
      return importPhoto(id, file);
    };
    const done = reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect(asked).toEqual(['p1', 'p2']);
    expect(store.album.value.get('p1')?.meta?.subjects).toEqual([face]);
    read();
    await done;
    store.sketch.value = false;
    painted.value = true;
    await settle();
    expect(asked).toEqual(['p1', 'p2', 'p1', 'p2']);
    expect(store.album.value.get('p2')?.meta?.subjects).toEqual([face, dog]);
  });

  it('does not repeat the first look at a draft without faces', async () => {
    const { reading, files, asked, store, engine, drafts, painted } = app(async () => ({ boxes: [], closer: false }));
    const { importPhoto } = engine;
    engine.importDraft = async (id: string, file: File) => {
      drafts.add(id);
      return importPhoto(id, file);
    };
    let read = () => {};
    const arrived = new Promise<void>((resolve) => {
      read = resolve;
    });
    engine.importPhoto = async (id: string, file: File) => {
      await arrived;
      drafts.delete(id);
      return importPhoto(id, file);
    };
    const done = reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect(asked).toEqual(['p1', 'p2']);
    read();
    await done;
    store.sketch.value = false;
    painted.value = true;
    await settle();
    expect(asked).toEqual(['p1', 'p2']);
  });

  it('tells of the photos in which it looked while there was no page', async () => {
    const { reading, files, asked, store, engine } = app(async () => ({ boxes: [], closer: false }));
    const { importPhoto } = engine;
    engine.importPhoto = async (id: string, file: File) => {
      if (file.name === '2.jpg') await new Promise((read) => setTimeout(read, 50));
      return importPhoto(id, file);
    };
    const done = reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect([store.sketch.value, asked, [...store.faced.value]]).toEqual([true, ['p1'], ['p1']]);
    await done;
  });

  it('makes the nets ready when photos are about to come; without them the first page waits for no face', async () => {
    const { reading, files, subjects, painted, asked, store, nets } = app(async () => ({ boxes: [], closer: false }));
    subjects.expect();
    expect(nets.asked).toBe(1);
    nets.ready = false;
    await reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect([asked, store.sketch.value]).toEqual([[], false]);
    painted.value = true;
    await settle();
    expect(asked).toEqual(['p1', 'p2']);
    const before = nets.asked;
    subjects.expect();
    expect(nets.asked).toBe(before);
  });

  it('finds objects beside the faces, and tells of a photo when both are known', async () => {
    let answer: (value: any) => void = () => {};
    const { reading, files, painted, objects, store } = app(
      () =>
        new Promise((done) => {
          answer = done;
        }),
      [dog],
    );
    await reading.addFiles(files('1.jpg', '2.jpg'));
    painted.value = true;
    await settle();
    expect(objects).toEqual(['p1', 'p2']);
    expect(store.album.value.get('p1')?.meta?.subjects).toEqual([]);
    answer({ boxes: [face], closer: false });
    await settle();
    expect(store.album.value.get('p1')?.meta?.subjects).toEqual([face, dog]);
    expect(store.album.value.get('p2')?.meta?.subjects).toEqual([]);
  });

  it('says once that there are no detectors, and asks no more', async () => {
    const { reading, files, subjects, painted, asked, messages } = app(async () => {
      throw Object.assign(new Error('gone'), { code: 'detector-missing' });
    });
    painted.value = true;
    await reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect(asked).toHaveLength(1);
    expect(messages.list.value).toHaveLength(1);
    expect(subjects.settled.value).toBe(true);
  });

  it('lets the first page not wait for faces if the detectors are missing', async () => {
    const { reading, files, store, engine } = app(async () => {
      throw Object.assign(new Error('gone'), { code: 'detector-missing' });
    });
    const { importPhoto } = engine;
    engine.importPhoto = async (id: string, file: File) => {
      if (file.name === '2.jpg') await new Promise((read) => setTimeout(read, 50));
      return importPhoto(id, file);
    };
    const done = reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect([store.sketch.value, [...store.faced.value]]).toEqual([true, ['p1', 'p2']]);
    await done;
  });

  it('tries again when the connection is back, and says nothing twice', async () => {
    const net = { there: false };
    const window = Object.assign(new EventTarget(), { navigator: { onLine: false } });
    const { reading, files, subjects, painted, asked, messages } = app(
      async () => {
        if (!net.there) throw Object.assign(new Error('gone'), { code: 'detector-missing' });
        return { boxes: [face], closer: false };
      },
      [],
      window,
    );
    painted.value = true;
    await reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect(messages.list.value.map(({ text }) => text)).toEqual([expect.stringContaining('Until you are online')]);
    window.dispatchEvent(new Event('online'));
    await settle();
    expect(messages.list.value).toHaveLength(1);
    net.there = true;
    window.dispatchEvent(new Event('online'));
    await settle();
    expect(asked).toEqual(['p1', 'p1', 'p1', 'p2']);
    expect(subjects.settled.value).toBe(true);
  });

  it('passes over a photo that cannot be looked at', async () => {
    const { reading, files, subjects, painted, asked, messages } = app(async (id) => {
      if (id === 'p1') throw Object.assign(new Error('gone'), { code: 'missing-photo' });
      return { boxes: [], closer: false };
    });
    painted.value = true;
    await reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect(asked).toEqual(['p1', 'p2']);
    expect(messages.list.value).toEqual([]);
    expect(subjects.settled.value).toBe(true);
  });
});
