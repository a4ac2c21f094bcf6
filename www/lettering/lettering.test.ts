import { beforeEach, describe, expect, onTestFinished, test, vi } from 'vitest';
import { createLettering } from './lettering.ts';
import { setWords } from './word-planning.ts';
import { createSelection } from '../page/panels/selection.ts';
import { fakeApp } from '../document/testing.ts';
import { wordName } from '../document/word-names.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { KnownPhoto } from '../engine/words.ts';

let lettering: ReturnType<typeof createLettering>;
let store: ReturnType<typeof fakeApp>['store'];
let pages: ReturnType<typeof fakeApp>['pages'];
let messages: ReturnType<typeof fakeApp>['messages'];
let selection: ReturnType<typeof createSelection>;
/** The known photos at each placement of text. */
let asked: Record<string, KnownPhoto>[] = [];

/** The place of each text item in the reading order, as the core finds it. */
let turns: number[] = [];

/** Whether text items fit where they are. */
let fits = false;

/** Whether text items that the user placed cover a face, so that they move. */
let onFace = false;

/** A simple model of the core: automatic items go to a quarter of their panel, and all are a tenth of the page wide. */
const letters = {
  settle: ({ words }: any, photos: Record<string, KnownPhoto>) => {
    asked.push(photos);
    const moved = (word: Word) => (onFace ? { ...word, x: 0.4 } : word);
    return words.map((word: Word) => (word.auto ? { ...word, x: 0.25, y: 0.25, tail: null } : moved(word)));
  },
  stay: ({ words }: any, _photos: Record<string, KnownPhoto>, index: number) =>
    fits && words[index].auto ? words : null,
  measure: ({ words }: any) =>
    words.map(({ x = 0.5, y = 0.5, tail, size }: Word, i: number) => ({
      x: x - 0.05,
      y: y - 0.05,
      width: 0.1,
      height: 0.1,
      tip: tail ? [tail.x, tail.y] : null,
      size: typeof size === 'number' ? size : 0.02,
      cut: false,
      turn: turns[i] ?? i,
    })),
};

beforeEach(async () => {
  asked = [];
  turns = [];
  fits = false;
  onFace = false;
  const app = fakeApp({}, { settled: (page) => lettering.settled(page) });
  ({ store, pages, messages } = app);
  selection = createSelection({ store });
  const { scheduler } = app;
  lettering = createLettering({ store, messages, selection, scheduler, load: async () => letters as any });
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
});

const past = () => store.mirror.peek().undos;

describe('words', () => {
  test('one is added, placed and chosen as one step', async () => {
    const before = past();
    expect(await lettering.add('balloon')).toBe(true);
    const photo = store.page.value?.panels[0].photo;
    expect(lettering.words.value).toEqual([
      {
        kind: 'balloon',
        text: 'Hello!',
        panel: 0,
        photo,
        auto: true,
        language: 'en',
        x: 0.25,
        y: 0.25,
      },
    ]);
    expect([lettering.chosen.value, past() - before]).toEqual([0, 1]);
    await lettering.add('caption');
    expect(lettering.words.value[1].panel).toBe(1);
    pages.undo();
    pages.undo();
    expect(lettering.words.value).toEqual([]);
  });

  test('a title belongs to the page instead of a panel, in the lettering of titles', async () => {
    selection.set([1]);
    expect(await lettering.add('title')).toBe(true);
    const [title] = lettering.words.value;
    expect(title).toMatchObject({ kind: 'caption', text: 'Our story', font: 'bangers', boxless: true, auto: true });
    expect([title.panel ?? null, title.photo ?? null]).toEqual([null, null]);
    expect(wordName(title)).toBe('Title: Our story');
    pages.undo();
    expect(lettering.words.value).toEqual([]);
  });

  test('a new one and its first text are one step, and another text is a second step', async () => {
    const before = past();
    await lettering.add('balloon');
    lettering.write(0, 'Well', lettering.typingStep(0));
    expect(past() - before).toBe(1);
    lettering.write(0, 'Well, well', lettering.typingStep(0));
    expect(past() - before).toBe(2);
    pages.undo();
    expect(lettering.words.value.map(({ text }) => text)).toEqual(['Well']);
    pages.undo();
    expect(lettering.words.value).toEqual([]);
  });

  test('the text of another item does not join the step of a new one', async () => {
    await lettering.add('balloon');
    await lettering.add('caption');
    const before = past();
    lettering.write(0, 'Well', lettering.typingStep(0));
    lettering.write(1, 'Later', lettering.typingStep(1));
    expect(past() - before).toBe(2);
  });

  test('another one goes to the panel that was selected for the first, while the first is chosen', async () => {
    selection.set([1]);
    await lettering.add('balloon');
    selection.clear();
    lettering.choose(0);
    await lettering.add('balloon');
    lettering.choose(-1);
    await lettering.add('effect');
    expect(lettering.words.value.map(({ panel }) => panel)).toEqual([1, 1, 0]);
  });

  test('the list has the order of the eye, and a text moves in it to the panel of its neighbours', async () => {
    turns = [2, 0, 1];
    await lettering.addAll([
      { kind: 'balloon', text: 'last', panel: 1, auto: false, x: 0.9, y: 0.9 },
      { kind: 'balloon', text: 'first', panel: 0, auto: true },
      { kind: 'balloon', text: 'second', panel: 0, auto: false, x: 0.8, y: 0.8 },
    ]);
    const read = () => lettering.reading.value.map((i) => lettering.words.value[i]);
    expect(read().map(({ text }) => text)).toEqual(['first', 'second', 'last']);
    const before = past();
    turns = [];
    lettering.reorder(2, 0);
    expect(past() - before).toBe(1);
    expect(read().map(({ text, panel }) => [text, panel])).toEqual([
      ['last', 0],
      ['first', 0],
      ['second', 0],
    ]);
    // It is placed again, and text that the user placed stays.
    expect(read().map(({ auto, x }) => [auto, x])).toEqual([
      [true, 0.25],
      [true, 0.25],
      [false, 0.8],
    ]);
    expect([lettering.chosen.value, lettering.words.value[0].photo]).toEqual([0, store.page.value?.panels[0].photo]);
    lettering.reorder(0, 5);
    lettering.reorder(1, 1);
    expect(past() - before).toBe(1);
  });

  test('texts are replaced on pages and among unplaced ones as one step, and others stay', async () => {
    await lettering.ready();
    const word = { kind: 'balloon', auto: true } as const;
    lettering.lay([
      { ...word, text: 'old', sheet: store.project.peek().sheet, panel: 0 },
      { ...word, text: 'gone', sheet: store.project.peek().sheet, panel: 1 },
      { ...word, text: 'waits' },
      { ...word, text: 'stays' },
    ]);
    const texts = () => [lettering.words.value, lettering.waiting.value].map((list) => list.map(({ text }) => text));
    expect(texts()).toEqual([
      ['old', 'gone'],
      ['waits', 'stays'],
    ]);
    lettering.edit(0, { x: 0.7, auto: false });
    const steps = past();
    const news = new Map([
      ['old', 'new'],
      ['gone', ''],
      ['waits', 'came'],
      ['other', 'x'],
    ]);
    expect(lettering.reword(news, lettering.step())).toBe(3);
    expect(texts()).toEqual([['new'], ['came', 'stays']]);
    expect([lettering.words.value[0].x, past() - steps]).toEqual([0.7, 1]);
    pages.undo();
    expect(texts()).toEqual([
      ['old', 'gone'],
      ['waits', 'stays'],
    ]);
  });

  test('text is written; nothing removes the word', async () => {
    await lettering.add('caption');
    lettering.write(0, ' e\u0301te\u0301 \n');
    expect(lettering.words.value[0].text).toBe('été');
    const steps = past();
    lettering.write(0, 'été');
    expect(past()).toBe(steps);
    lettering.write(0, '  ');
    expect(lettering.words.value).toEqual([]);
    pages.undo();
    expect(lettering.words.value[0].text).toBe('été');
  });

  test('an automatic text stays where it is while its text changes, or close to it', async () => {
    await lettering.addAll([
      { kind: 'balloon', text: 'Hm', panel: 0, auto: true },
      { kind: 'balloon', text: 'Mine', panel: 1, auto: false, x: 0.9, y: 0.9 },
    ]);
    lettering.move(0, [0.6, 0.6]);
    lettering.edit(0, { auto: true });
    const places = () => lettering.words.value.map(({ x, auto }) => [x, auto]);
    expect(places()).toEqual([
      [0.25, true],
      [0.9, false],
    ]);
    const page = store.page.peek() as PageDocument;
    setWords(store, [{ at: 0, page: { ...page, words: page.words?.map((word) => ({ ...word, x: 0.7 })) } }]);
    fits = true;
    const before = past();
    lettering.write(0, 'Hm, who is there?');
    lettering.edit(0, { size: 0.03 });
    lettering.write(1, 'Mine!');
    expect([places(), past() - before]).toEqual([
      [
        [0.7, true],
        [0.7, false],
      ],
      3,
    ]);
    fits = false;
    const longer = 'Hm, who is there behind the door?';
    // The field of the text shows the place that the text gets.
    const field = lettering.measured(0, longer);
    lettering.write(0, longer);
    expect(places()).toEqual([
      [0.7, true],
      [0.7, false],
    ]);
    expect(lettering.boxes.value[0]).toEqual(field);
    fits = true;
    lettering.settleOne(0);
    expect(places()[0]).toEqual([0.25, true]);
    const now = store.page.peek() as PageDocument;
    setWords(store, [{ at: 0, page: { ...now, words: now.words?.map((word) => ({ ...word, x: 0.7 })) } }]);
    lettering.edit(0, { shape: 'shout' });
    expect(places()[0], 'another shape needs other room').toEqual([0.25, true]);
  });

  test('a long text gets a place when its user pauses, and keeps it while it is typed further', async () => {
    const sized = vi
      .spyOn(letters, 'measure')
      .mockImplementation(({ words }) =>
        words.map(({ x = 0.5, y = 0.5, text }: Word) => ({ x, y, width: text.length / 1000, height: 0.1 })),
      );
    onTestFinished(() => sized.mockRestore());
    await lettering.addAll([{ kind: 'balloon', text: 'Hm', panel: 0, auto: true }]);
    const page = store.page.peek() as PageDocument;
    setWords(store, [{ at: 0, page: { ...page, words: page.words?.map((word) => ({ ...word, x: 0.7 })) } }]);
    lettering.editing.value = 0;
    const across = (length: number, isAtRest?: boolean) => lettering.measured(0, 'x'.repeat(length), isAtRest)?.x;
    onFace = true;
    expect([across(100), across(200)]).toEqual([0.4, 0.4]);
    onFace = false;
    expect([across(210), across(220, true), across(230)]).toEqual([0.4, 0.7, 0.7]);
    onFace = true;
    expect([across(240), across(250, true)]).toEqual([0.7, 0.4]);
    asked = [];
    expect([across(700, true), lettering.measured(0, 'x'.repeat(700))?.width, asked.length]).toEqual([0.4, 0.7, 0]);
    // Another edit begins where the text item is.
    lettering.editing.value = -1;
    expect(across(200)).toBe(0.7);
  });

  test('the list shows the text that is typed, and the page the text that is accepted', async () => {
    await lettering.add('caption');
    lettering.write(0, 'old');
    lettering.editing.value = 0;
    expect(lettering.textOf(0)).toBe('old');
    lettering.typed.value = 'new';
    expect([lettering.textOf(0), lettering.words.value[0].text]).toEqual(['new', 'old']);
    lettering.editing.value = -1;
    expect(lettering.textOf(0)).toBe('old');
  });

  test('the draft has the text that is typed, until the edit ends', async () => {
    await lettering.add('balloon');
    lettering.write(0, 'old');
    lettering.editing.value = 0;
    lettering.measured(0, 'old');
    expect(lettering.draft.value).toBeNull();
    lettering.measured(0, 'older');
    expect(lettering.draft.value?.words?.[0].text).toBe('older');
    const long = 'x'.repeat(700);
    lettering.measured(0, long);
    expect(lettering.draft.value?.words?.[0].text).toBe(long);
    expect(lettering.words.value[0].text).toBe('old');
    lettering.write(0, 'older');
    expect(lettering.draft.value).toBeNull();
  });

  test('the font and the size of one are used for all with its role, as one step', async () => {
    for (const role of ['balloon', 'balloon', 'caption', 'title'] as const) await lettering.add(role);
    lettering.edit(1, { font: 'bangers', size: 0.03, auto: false, x: 0.7, y: 0.8 });
    lettering.edit(0, { size: 0.01 });
    const [before, steps] = [lettering.words.value, past()];
    expect(before.map((_, i) => lettering.alike(i))).toEqual([[1], [0], [], []]);
    lettering.match(1, lettering.step());
    const after = lettering.words.value;
    expect(after.map(({ font, size }) => [font, size]).slice(0, 2)).toEqual(Array(2).fill(['bangers', 0.03]));
    expect([after[1].x, after[1].y]).toEqual([0.7, 0.8]);
    expect(after.slice(2)).toEqual(before.slice(2));
    expect(past()).toBe(steps + 1);
    lettering.match(0);
    expect(lettering.words.value[0].size).toBe(0.03);
  });

  test('a drag is one step, and what was moved stays where it is through every shuffle', async () => {
    await lettering.add('balloon');
    const steps = past();
    const gesture = lettering.step();
    lettering.move(0, [0.4, 0.4], gesture);
    lettering.move(0, [0.6, 0.7], gesture);
    lettering.point(0, [0.9, 0.9], gesture);
    expect(past() - steps).toBe(1);
    expect(lettering.words.value[0]).toMatchObject({ x: 0.6, y: 0.7, tail: { x: 0.9, y: 0.9 }, auto: false });
    pages.shuffle('all');
    expect(lettering.words.value[0]).toMatchObject({ x: 0.6, y: 0.7 });
    lettering.point(0, null);
    expect(lettering.words.value[0].tail ?? null).toBeNull();
    lettering.settleOne(0);
    expect(lettering.words.value[0]).toMatchObject({ x: 0.25, auto: true });
  });

  test('the message about a removed text closes when the text is back', async () => {
    await lettering.add('balloon');
    lettering.remove(0);
    expect(messages.list.value.map(({ text }) => text)).toEqual(['“Balloon: Hello!” was removed.']);
    pages.undo();
    await Promise.resolve();
    expect([lettering.words.value.length, messages.list.value]).toEqual([1, []]);
  });

  test('another page has the words of this one whose photos it shows, on the panels of these', async () => {
    await lettering.add('effect');
    const page = store.page.value as PageDocument;
    const panels = page.panels.toReversed();
    const [word] = lettering.on({ ...page, panels, words: [] }).words;
    expect(word).toMatchObject({ text: 'BAM!', panel: panels.length - 1, photo: page.panels[0].photo });
    expect(lettering.on({ ...page, panels: [{ photo: 'x', crop: null }], words: [] }).words).toEqual([]);
  });

  test('words that are laid find places, wait for photos that no page shows, and do not come twice', async () => {
    await lettering.ready();
    const photo = store.page.value?.panels[1].photo as string;
    const said = (text: string, photo: string) =>
      ({ kind: 'balloon', text, photo, panel: 0, auto: true, cue: text }) as const;
    const fresh = [said('one', photo), said('two', 'elsewhere')];
    const steps = past();
    expect(lettering.lay(fresh)).toEqual({ shown: 1, waiting: 1 });
    expect(past() - steps).toBe(1);
    expect(lettering.words.value[0]).toMatchObject({ text: 'one', panel: 1, x: 0.25 });
    expect(lettering.lay(fresh)).toEqual({ shown: 0, waiting: 0 });
    // An unplaced item is placed on the page, and undo reverts that.
    lettering.take(0);
    expect([lettering.words.value.length, lettering.waiting.value.length]).toEqual([2, 0]);
    pages.undo();
    pages.undo();
    expect([lettering.words.value.length, lettering.waiting.value.length]).toEqual([0, 0]);
  });

  test('another page takes no more unplaced text of its photos than it holds', async () => {
    await lettering.ready();
    const page = store.page.value as PageDocument;
    const photo = page.panels[0].photo as string;
    const said = (_: unknown, i: number) => ({ kind: 'balloon', text: `${i}`, photo, panel: 0, auto: true }) as const;
    expect(lettering.lay(Array.from({ length: 250 }, said))).toEqual({ shown: 200, waiting: 50 });
    expect(lettering.on({ ...page, words: [] }).words).toHaveLength(200);
  });

  test('text without a photo is unplaced, the first of it up to a limit, until it is put on a page', async () => {
    await lettering.ready();
    const said = (_: unknown, i: number) => ({ kind: 'balloon', text: `${i}`, auto: true }) as const;
    expect(lettering.lay(Array.from({ length: 2_100 }, said))).toEqual({ shown: 0, waiting: 2_000 });
    expect([lettering.waiting.value[0].text, lettering.waiting.value.at(-1)?.text]).toEqual(['0', '1999']);
    expect(lettering.lay([said(null, 7)])).toEqual({ shown: 0, waiting: 0 });
    pages.shuffle('all');
    expect([lettering.words.value.length, lettering.waiting.value.length]).toEqual([0, 2_000]);
    const page = store.page.value as PageDocument;
    expect(lettering.on(page).words).toEqual([]);
    lettering.take(0);
    const photo = store.page.value?.panels[0].photo;
    expect(lettering.words.value).toEqual([expect.objectContaining({ text: '0', panel: 0, photo })]);
    expect(lettering.waiting.value.length).toBe(1_999);
  });

  test('one is made wider and turned, each drag one step', async () => {
    await lettering.add('effect');
    const steps = past();
    const gesture = lettering.step();
    for (const width of [0.2, 0.3, 7]) lettering.resize(0, width, gesture);
    expect([lettering.words.value[0].width, past() - steps]).toEqual([0.96, 1]);
    lettering.turn(0, 270);
    expect(lettering.words.value[0].angle).toBe(-90);
  });

  test('words are placed by the masks of the photos, as far as these are there', async () => {
    const [first, second] = (store.page.value as PageDocument).panels.map(({ photo }) => photo as string);
    const fact = store.album.peek().get(first);
    if (fact?.meta) store.know({ ...fact, meta: { ...fact.meta, mask: '2x1:ap' } });
    await lettering.add('balloon');
    const known = asked.at(-1) ?? {};
    expect([known[first].mask, known[second].mask]).toEqual(['2x1:ap', undefined]);
    expect(known[first].subjects).toEqual(fact?.meta?.subjects);
  });

  test('a page that comes with words keeps their places when the letters are there', async () => {
    const page = store.page.value as PageDocument;
    const words: Word[] = [{ kind: 'caption', text: 'Later', panel: 0, auto: true, x: 0.7, y: 0.8 }];
    store.change({ type: 'change-page', page: { ...page, words } });
    await lettering.ready();
    await Promise.resolve();
    expect([lettering.words.value[0].x, asked.length]).toEqual([0.7, 0]);
  });

  test('the letters of a page that comes with words are told to be loading until they are there', async () => {
    const page = store.page.value as PageDocument;
    const words: Word[] = [{ kind: 'caption', text: 'Later', panel: 0, auto: true, x: 0.7, y: 0.8 }];
    expect(lettering.loading.value).toBe(false);
    store.change({ type: 'change-page', page: { ...page, words } });
    expect([lettering.loading.value, lettering.boxes.value.length]).toEqual([true, 0]);
    await lettering.ready();
    expect([lettering.loading.value, lettering.boxes.value.length]).toEqual([false, 1]);
  });

  test('words of a page that was planned before the letters were there are placed when they are', async () => {
    const page = store.page.value as PageDocument;
    const words: Word[] = [{ kind: 'caption', text: 'Later', panel: 0, auto: true, x: 0.7, y: 0.8 }];
    store.change({ type: 'change-page', page: lettering.settled({ ...page, words }) });
    await lettering.ready();
    await Promise.resolve();
    expect([lettering.words.value[0].x, asked.length]).toEqual([0.25, 1]);
  });

  test('without letters the page stays, and the reason is said', async () => {
    const app = fakeApp();
    const failing = createLettering({
      store: app.store,
      messages: app.messages,
      scheduler: app.scheduler,
      selection: createSelection({ store: app.store }),
      load: () => Promise.reject(new Error('offline')),
    });
    await app.reading.addFiles(app.files('a.jpg'));
    expect(await failing.add('caption')).toBe(false);
    expect(app.messages.list.value.at(-1)?.text).toContain('offline');
    expect(failing.words.value).toEqual([]);
    expect(failing.loading.value).toBe(false);
  });
});

describe('text that the user placed', () => {
  const own = { kind: 'balloon', text: 'Mine', panel: 0, auto: true, x: 0.7, y: 0.7 } as const;
  const titled = { kind: 'caption', text: 'Sintra', panel: 0, auto: true, made: true, x: 0.7, y: 0.7 } as const;
  const placesOf = (page: PageDocument | null) => page?.words?.map(({ x, auto }) => [x, auto]);

  test('stays when a photo was analysed again, unless it covers a face, and other text is placed again', async () => {
    await lettering.ready();
    const page = { ...(store.page.value as PageDocument), words: [own, titled] };
    expect(placesOf(lettering.cleared(page))).toEqual([
      [0.7, true],
      [0.25, true],
    ]);
    onFace = true;
    expect(placesOf(lettering.cleared(page))).toEqual([
      [0.4, true],
      [0.25, true],
    ]);
  });

  test('stays when only the style and its paper change', async () => {
    await lettering.ready();
    store.change({ type: 'change-page', page: { ...(store.page.value as PageDocument), words: [own] } });
    const page = store.page.value as PageDocument;
    const dark = { ...page.page, paper: '#101010', borderColor: '#fafafa' };
    expect(placesOf(lettering.settled({ ...page, style: 'moonlight', page: dark }))).toEqual([[0.7, true]]);
    const panels = [...page.panels].reverse();
    expect(placesOf(lettering.settled({ ...page, style: 'moonlight', panels }))).toEqual([[0.25, true]]);
  });

  test('stays when the glyphs are loaded after another page was planned ahead', async () => {
    const page = store.page.value as PageDocument;
    const ahead = { ...page, panels: [...page.panels].reverse(), words: [own] };
    expect(lettering.settled(ahead)).toBe(ahead);
    store.change({ type: 'change-page', page: { ...page, words: [own] } });
    await lettering.ready();
    await Promise.resolve();
    expect([placesOf(store.page.value), asked.length]).toEqual([[[0.7, true]], 0]);
  });
});
