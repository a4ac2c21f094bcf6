import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { nextTask } from '../engine/scheduler.ts';
import { strings } from '../strings/strings.ts';
import { createBookMaking } from './book-making.ts';
import { opened } from './book-testing.ts';

async function making(
  count: number,
  {
    searched = () => true,
    at = [null],
    offered = () => false,
  }: { searched?: () => boolean; at?: readonly (number | null)[]; offered?: () => boolean } = {},
) {
  const app = await opened(count);
  const ids = app.store.photos.peek().map(({ id }) => id);
  const moments = new Map(ids.map((id, i) => [id, { at: at[i % at.length], place: '' }]));
  const bookMaking = createBookMaking({
    store: app.store,
    book: app.book,
    pages: app.pages,
    album: { title: () => 'Trip', moments: () => moments },
    places: { offered, add: vi.fn(), marked: (page) => page },
    searched,
    ready: () => Promise.resolve(),
  });
  return { ...app, bookMaking };
}

test('a book has every photo once behind its cover, and is one undo step', async () => {
  const { bookMaking, store, shown, ids, pages, messages } = await making(14);
  const before = store.page.peek();
  await bookMaking.make('one');
  const [cover, ...others] = shown();
  expect(cover).toHaveLength(1);
  expect(others.flat().sort()).toEqual([...ids()].sort());
  expect(messages.list.peek().map(({ text }) => text)).toContain(`Your book has ${shown().length} pages.`);
  const texts = store.sheets.peek().flatMap(({ words = [] }) => words.map(({ text }) => text));
  expect(texts).toContain('Trip');
  expect(texts).toContain('The end');
  expect(texts).toContain('2');
  expect(bookMaking.progress.peek()).toBeNull();
  pages.undo();
  expect(store.sheets.peek()).toEqual([before]);
});

test('a text of the user is on one page of a book, and not on its cover', async () => {
  const { bookMaking, store, book, pages } = await making(14);
  // The photo of the cover is unknown, so all photos get a text.
  book.spreadAlbum();
  const said = store.sheets.peek().map((page, at) => ({
    at,
    words: page.panels.map(({ photo }, panel) => ({ kind: 'balloon' as const, text: `${photo}`, photo, panel })),
  }));
  store.change({ type: 'set-words', pages: said });
  await bookMaking.make('one');
  const texts = store.sheets.peek().map(({ words = [] }) => words.flatMap(({ made, text }) => (made ? [] : [text])));
  expect(texts[0]).toEqual([]);
  const all = texts.flat();
  expect(all.length).toBeGreaterThan(5);
  expect(new Set(all).size).toBe(all.length);
  pages.undo();
});

test('the cover is known wherever it is, and plain pages have none', async () => {
  const { bookMaking, book } = await making(14);
  book.spreadAlbum();
  expect([book.isMade.value, book.coverAt()]).toEqual([false, -1]);
  await bookMaking.make('one');
  expect([book.isMade.value, book.coverAt()]).toEqual([true, 0]);
  book.move(0, 2);
  expect(book.coverAt()).toBe(2);
});

test('the dates of a book have the format of the user', async () => {
  const { bookMaking, pages } = await making(14, { at: [Date.UTC(2026, 5, 9, 15)] });
  const made = vi.spyOn(pages, 'book');
  await bookMaking.make('one');
  expect(made.mock.calls[0][0].dates).toEqual({
    span: strings.dates(Date.UTC(2026, 5, 9), Date.UTC(2026, 5, 9)),
    days: { '2026-06-09': strings.shortDayOf(Date.UTC(2026, 5, 9)) },
  });
});

test('the hours after midnight belong to the day before', async () => {
  const { bookMaking, pages } = await making(14, { at: [Date.UTC(2026, 5, 9, 22), Date.UTC(2026, 5, 10, 1, 30)] });
  const made = vi.spyOn(pages, 'book');
  await bookMaking.make('one');
  expect(made.mock.calls[0][0].dates?.days).toEqual({ '2026-06-09': strings.shortDayOf(Date.UTC(2026, 5, 9)) });
});

test('the first day of each year of a book has its year', async () => {
  const times = [Date.UTC(2023, 10, 2, 9), Date.UTC(2024, 3, 11, 15), Date.UTC(2024, 4, 1, 15)];
  const { bookMaking, pages } = await making(14, { at: times });
  const made = vi.spyOn(pages, 'book');
  await bookMaking.make('one');
  const [november, april, may] = [Date.UTC(2023, 10, 2), Date.UTC(2024, 3, 11), Date.UTC(2024, 4, 1)];
  expect(made.mock.calls[0][0].dates).toEqual({
    span: strings.dates(november, may),
    days: {
      '2023-11-02': strings.dates(november, november),
      '2024-04-11': strings.dates(april, april),
      '2024-05-01': strings.shortDayOf(may),
    },
  });
});

test('a book of photos with locations offers their place names', async () => {
  const { bookMaking, messages } = await making(14, { offered: () => true });
  await bookMaking.make('one');
  expect(messages.list.peek().at(-1)?.more?.label).toBe(strings.addPlaces);
});

test('page numbers follow a move, and a shuffle keeps the text of a book', async () => {
  const { bookMaking, store, book, pages } = await making(14);
  await bookMaking.make('one');
  const numbers = () => store.sheets.peek().map(({ words = [] }) => words.find(({ number }) => number)?.text ?? '');
  const before = numbers();
  book.move(1, 2);
  expect(numbers()).toEqual(before);
  book.go(0);
  const title = () => store.page.peek()?.words?.map(({ text }) => text);
  expect(title()?.[0]).toBe('Trip');
  pages.shuffle('all');
  expect(title()?.[0]).toBe('Trip');
});

test('a book waits for faces, and Cancel leaves the pages as they are', async () => {
  const searched = signal(false);
  const { bookMaking, store } = await making(14, { searched: () => searched.value });
  const before = store.sheets.peek();
  const made = bookMaking.make('one');
  expect(bookMaking.progress.peek()).toEqual({ done: 0, of: 0 });
  bookMaking.cancel();
  await made;
  expect(store.sheets.peek()).toEqual(before);
  const second = bookMaking.make('one');
  await nextTask();
  expect(store.sheets.peek()).toEqual(before);
  searched.value = true;
  await second;
  expect(store.sheets.peek().length).toBeGreaterThan(3);
});

test('a book waits for faces no longer than fifteen seconds', async () => {
  const { bookMaking, store } = await making(14, { searched: () => false });
  vi.useFakeTimers();
  const made = bookMaking.make('one');
  await vi.advanceTimersByTimeAsync(14_900);
  expect(store.sheets.peek()).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(1_000);
  vi.useRealTimers();
  await made;
  expect(store.sheets.peek().length).toBeGreaterThan(3);
});

test('a book replaces the text of the book before, and keeps the text of the user', async () => {
  const { bookMaking, store } = await making(14);
  await bookMaking.make('one');
  const page = store.page.peek();
  if (!page) throw new Error('There is no page.');
  const photo = page.panels[0].photo ?? '';
  const own = { kind: 'balloon', text: 'Mine', panel: 0, photo } as const;
  store.change({ type: 'change-page', page: { ...page, words: [...(page.words ?? []), own] } });
  await bookMaking.make('one');
  const texts = store.sheets.peek().flatMap(({ words = [] }) => words.map(({ text }) => text));
  expect(texts.filter((text) => text === 'Trip')).toHaveLength(1);
  expect(texts).toContain('Mine');
});
