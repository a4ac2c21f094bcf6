import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { fakeApp, orderByName } from '../document/testing.ts';
import { planAgain } from './second-plan.ts';

const FACE = { label: 'face', score: 1, x: 0.3, y: 0.2, width: 0.3, height: 0.4 };
const expression = (eye: number) => ({ rightEye: eye, leftEye: eye, mouth: 0, smile: 0 });
const ten = Array.from({ length: 10 }, (_, i) => `${i}.jpg`);

/**
 * A first page of the first six of ten photos.
 * @param people names of photos with a face
 * @param asleep names of photos with shut eyes
 */
async function app(people: readonly string[], asleep: readonly string[] = []) {
  const made = fakeApp();
  const { store, pages, messages, planner, reading, files } = made;
  orderByName({ store });
  // The planner chooses photos with subjects, and keeps the order of the others.
  planner.planned = (page, { type }) => {
    if (type !== 'compose') return page;
    const rank = ({ subjects }: { subjects: readonly unknown[] }) => (subjects.length > 0 ? 0 : 1);
    const ids = [...store.photos.value].sort((a, b) => rank(a) - rank(b)).map(({ id }) => id);
    return { ...page, panels: page.panels.map((panel, i) => ({ ...panel, photo: ids[i], crop: null })) };
  };
  await reading.addFiles(files(...ten));
  const page = store.page.value as NonNullable<typeof store.page.value>;
  const first = store.photos.value.slice(0, page.panels.length).map(({ id }) => id);
  const panels = page.panels.map((panel, i) => ({ ...panel, photo: first[i] }));
  store.change({ type: 'change-page', page: { ...page, panels }, silent: true });
  const [faced, searched] = [signal(false), signal(false)];
  const composed = signal<{ version: string; at: number } | null>({ version: store.version.value, at: 0 });
  const window = new EventTarget();
  const clock = { now: 20_000 };
  const { keepShown } = reading;
  const signals = { composed, faced, searched };
  planAgain({ store, pages, messages, ...signals, keepShown, window: window as Window, now: () => clock.now });
  const find = () => {
    for (const fact of store.facts.value) {
      const face = { ...FACE, expression: expression(asleep.includes(fact.name) ? 0.1 : 0.3) };
      if (people.includes(fact.name) && fact.meta) store.know({ ...fact, meta: { ...fact.meta, subjects: [face] } });
    }
  };
  /** Ends the detection. */
  const search = () => {
    find();
    searched.value = true;
  };
  const names = () => store.page.value?.panels.map(({ photo }) => store.album.value.get(String(photo))?.name);
  return { ...made, composed, faced, searched, window, clock, find, search, names };
}

test('a better choice of photos replaces the first page, in its layout and style, and can be undone', async () => {
  const { store, pages, messages, search, names } = await app(['8.jpg', '9.jpg']);
  const [before, first] = [store.page.value, names()];
  expect(names()).not.toContain('9.jpg');
  search();
  expect(names()).toEqual(expect.arrayContaining(['8.jpg', '9.jpg']));
  expect([store.page.value?.layout, store.page.value?.style]).toEqual([before?.layout, before?.style]);
  expect(store.mirror.value.undos).toBe(1);
  expect(messages.list.value.length).toBe(1);
  pages.undo();
  expect(names()).toEqual(first);
});

test('a better choice replaces the first page when all faces are known, before the detection ends', async () => {
  const { faced, find, search, names } = await app(['8.jpg', '9.jpg']);
  find();
  expect(names()).not.toContain('9.jpg');
  faced.value = true;
  const replaced = names();
  expect(replaced).toEqual(expect.arrayContaining(['8.jpg', '9.jpg']));
  search();
  expect(names()).toEqual(replaced);
});

test('another first page is also replaced when all faces are known', async () => {
  const { store, pages, composed, faced, find, names } = await app(['8.jpg', '9.jpg']);
  faced.value = true;
  composed.value = null;
  faced.value = false;
  const page = store.page.value as NonNullable<typeof store.page.value>;
  pages.show({ ...page, style: 'noir' }, { silent: true });
  composed.value = { version: store.version.value, at: 0 };
  find();
  expect(names()).not.toContain('9.jpg');
  faced.value = true;
  expect(names()).toContain('9.jpg');
});

test('the choice is compared again at the end of the detection, if the faces changed nothing', async () => {
  const { faced, search, names } = await app(['9.jpg']);
  const before = names();
  faced.value = true;
  expect(names()).toEqual(before);
  search();
  expect(names()).toContain('9.jpg');
});

test('a page that was hardly visible is replaced without a step', async () => {
  const { store, messages, clock, search, names } = await app(['8.jpg', '9.jpg']);
  clock.now = 900;
  search();
  expect(names()).toContain('9.jpg');
  expect([store.mirror.value.undos, messages.list.value]).toEqual([0, []]);
});

test('it is replaced once at most', async () => {
  const { store, searched, search, names, planner } = await app(['9.jpg']);
  search();
  const after = names();
  const asked = planner.wishes.length;
  searched.value = false;
  const seven = store.facts.value.find(({ name }) => name === '7.jpg') as any;
  store.know({ ...seven, meta: { ...seven.meta, subjects: [FACE] } });
  searched.value = true;
  expect(names()).toEqual(after);
  expect(planner.wishes.length).toBe(asked);
});

test('it stays if the choice is hardly better', async () => {
  const { search, names } = await app(['0.jpg', '1.jpg']);
  const before = names();
  search();
  expect(names()).toEqual(before);
});

test.each(['pointerdown', 'keydown', 'wheel'])('it stays after any act of the user: %s', async (act) => {
  const { window, search, names } = await app(['9.jpg']);
  const before = names();
  window.dispatchEvent(new Event(act));
  search();
  expect(names()).toEqual(before);
});

test('a page that was shuffled or is old stays', async () => {
  const shuffled = await app(['9.jpg']);
  shuffled.pages.shuffle('all');
  const page = shuffled.store.page.value;
  shuffled.search();
  expect(shuffled.store.page.value).toBe(page);
  const old = await app(['9.jpg']);
  const before = old.names();
  old.clock.now = 61_000;
  old.search();
  expect(old.names()).toEqual(before);
});

test('it is not replaced while photos are read', async () => {
  const { store, search, names } = await app(['9.jpg']);
  store.reading.value = { done: 9, total: 10 };
  const before = names();
  search();
  expect(names()).toEqual(before);
  store.reading.value = null;
  expect(names()).toContain('9.jpg');
});

/** A choice for which 9.jpg is like 0.jpg, and the first is sharper. */
function chooseByEyes(planner: { choose: (photos: any[]) => any[] }) {
  planner.choose = (photos) => {
    const isShut = (name: string) =>
      photos.some((photo) => photo.name === name && photo.faces.some(({ rightEye }: any) => rightEye < 0.16));
    const awake = isShut('0.jpg') && !isShut('9.jpg');
    const pair: Record<string, object> = {
      '0.jpg': { kept: !awake, why: awake ? 'same as 9.jpg' : 'sharpest of 2' },
      '9.jpg': { kept: awake, why: awake ? 'open eyes, best of 2' : 'same as 0.jpg' },
    };
    return photos.map(({ id, name }, i) => ({
      id,
      ...(pair[name] ? { group: 0, ...pair[name] } : { group: i + 1, kept: true, why: 'only one like it' }),
    }));
  };
}

test('a near-duplicate with open eyes replaces a photo of the first page', async () => {
  const { planner, search, names } = await app(['0.jpg', '9.jpg'], ['0.jpg']);
  chooseByEyes(planner);
  expect(names()).toContain('0.jpg');
  search();
  expect(names()).toContain('9.jpg');
  expect(names()).not.toContain('0.jpg');
});

test('a page that the user has touched keeps its photo with shut eyes in use', async () => {
  const { store, planner, window, find, search, names } = await app(['0.jpg', '9.jpg'], ['0.jpg']);
  chooseByEyes(planner);
  const before = names();
  find();
  window.dispatchEvent(new Event('keydown'));
  search();
  expect(names()).toEqual(before);
  const used = store.photos.value.map(({ id }) => store.album.value.get(id)?.name);
  expect(used).toContain('0.jpg');
  expect(used).not.toContain('9.jpg');
});

/** Makes the photos frames of a video. The first two photos of the page have the same shot. */
function asFilm({ store }: Pick<Awaited<ReturnType<typeof app>>, 'store'>) {
  const [, second] = store.page.value?.panels ?? [];
  store.facts.value.forEach((fact, i) =>
    store.know({ ...fact, video: 'film', shot: fact.id === second.photo ? 1 : i + 1 }),
  );
}

test('a page of a video gets other shots when the video is read, before the detection ends', async () => {
  const made = await app([]);
  const { store, names, planner } = made;
  const planned = planner.planned as NonNullable<typeof planner.planned>;
  planner.planned = (page, wish) => {
    if (wish.type !== 'compose') return planned(page, wish);
    return { ...page, panels: page.panels.map((panel, i) => ({ ...panel, photo: wish.photos[i], crop: null })) };
  };
  store.reading.value = { done: 9, total: 10 };
  asFilm(made);
  const before = names();
  store.reading.value = null;
  expect(names()).not.toEqual(before);
  expect(new Set(store.page.value?.panels.map(({ photo }) => store.album.value.get(String(photo))?.shot)).size).toBe(6);
});

test('other shots of a video are chosen from the frames that were read', async () => {
  const made = await app([]);
  const { store, planner } = made;
  const asked: string[] = [];
  planner.planned = (page, wish) => {
    if (wish.type === 'compose') asked.push(...wish.photos);
    return page;
  };
  store.reading.value = { done: 9, total: 10 };
  asFilm(made);
  const last = store.facts.value[9];
  store.know({ ...last, meta: null });
  store.reading.value = null;
  expect(asked.length).toBeGreaterThan(5);
  expect(asked).not.toContain(last.id);
});

test('a page of a video without repeated shots waits for the detection', async () => {
  const { store, names, search } = await app(['9.jpg']);
  const before = names();
  store.reading.value = { done: 9, total: 10 };
  store.facts.value.forEach((fact, i) => store.know({ ...fact, video: 'film', shot: i + 1 }));
  store.reading.value = null;
  expect(names()).toEqual(before);
  search();
  expect(names()).toContain('9.jpg');
});
