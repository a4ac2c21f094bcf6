/** Makes a book of all photos: cover, chapters by day, captions, page numbers, end page. One undo step. */

import { effect, signal } from '@preact/signals';
import { timeLimit } from '../engine/scheduler.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { language, strings } from '../strings/strings.ts';
import type { Signal } from '@preact/signals';
import type { Sheet } from '../engine/sheets.ts';
import type { BookDates, BookStyles, PageDocument, Word } from '../engine/types.ts';
import type { Book } from './book.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';

export type BookMaking = ReturnType<typeof createBookMaking>;

/** Maximum time in ms to wait for faces, which choose the cover. Crops follow later detections. */
const PATIENCE = 15_000;
const DAY = 86_400_000;
/** Time of a night at which the next day begins, as in `crates/engine/src/plan/moments.rs`. */
const MORNING = 4 * 3_600_000;

/**
 * @param app `album`: the title of the album, and the places of its photos. `places`: names of places that the user may add.
 * `searched` reads signals: whether all photos were looked at;
 * `ready` loads what places text
 */
export function createBookMaking({
  store,
  book,
  pages,
  album,
  places,
  searched,
  ready,
}: {
  store: Store;
  book: Pick<Book, 'cannotSpread' | 'replace' | 'hasDays'>;
  pages: Pick<Pages, 'book'>;
  album: { title: () => string; moments: () => ReadonlyMap<string, { at: number | null; place: string }> };
  places: { offered: () => boolean; add: () => void; marked: (page: PageDocument) => PageDocument };
  searched: () => boolean;
  ready: () => Promise<unknown>;
}) {
  /** Pages that are planned, and their number, which is 0 while photos are looked at; null if no book is made. */
  const progress = signal(null) as Signal<{ done: number; of: number } | null>;
  let stop: AbortController | null = null;
  let last: BookStyles = 'one';
  const withChapters = { label: strings.book.makeChapters, run: () => void make('chapters') };
  const withPlaces = {
    label: strings.addPlaces,
    run: () => {
      places.add();
      void again();
    },
  };

  return { progress, make, again, cancel };

  /** Makes the book again, with as many styles as before. */
  function again() {
    return make(last);
  }

  /** @param styles one style for all pages, or one per chapter */
  async function make(styles: BookStyles) {
    if (progress.peek() || !store.project.peek().page || book.cannotSpread() !== '') return;
    stop = new AbortController();
    const { signal } = stop;
    progress.value = { done: 0, of: 0 };
    try {
      await Promise.all([ready(), looked(signal)]);
      const before = store.project.peek();
      const moments = album.moments();
      const named = Object.fromEntries([...moments].map(([id, { place }]) => [id, place]));
      const dates = datesOf(store.photos.peek().map(({ id }) => moments.get(id)?.at ?? null));
      const told = (done: number, of: number) => {
        progress.value = { done, of };
      };
      const sheets = signal.aborted
        ? null
        : await pages.book({ title: album.title(), language, places: named, dates, styles }, told, signal);
      if (!sheets || sheets.length === 0) return;
      last = styles;
      book.replace(
        once(sheets).map((sheet) => ({ ...sheet, page: places.marked(sheet.page) })),
        {
          text: strings.book.made({ n: sheets.length }),
          before: sheetsOf(before),
          at: before.at,
          more: places.offered() ? withPlaces : styles === 'one' && book.hasDays.peek() ? withChapters : undefined,
        },
      );
    } finally {
      progress.value = null;
      stop = null;
    }
  }

  function cancel() {
    stop?.abort();
  }

  /** Waits until all photos are searched, within the time limit and until it is cancelled. */
  async function looked(signal: AbortSignal) {
    const ends: (() => void)[] = [];
    await new Promise<void>((resolve) => {
      ends.push(timeLimit(PATIENCE, resolve));
      ends.push(effect(() => void (searched() && resolve())));
      signal.addEventListener('abort', () => resolve(), { once: true });
    });
    for (const end of ends) end();
  }
}

/**
 * Leaves each text of the user on one page, because cover and end show photos of other pages. The cover has a text only if no
 * other page has it.
 */
function once(sheets: readonly Sheet[]): Sheet[] {
  const seen = new Set<string>();
  const keyOf = ({ photo, kind, text }: Word) => JSON.stringify([photo, kind, text]);
  const wordsOf = ({ page }: Sheet) => {
    const words = page.words?.filter((word) => word.made || !seen.has(keyOf(word)));
    for (const word of words ?? []) if (!word.made) seen.add(keyOf(word));
    return words;
  };
  const [cover, ...others] = sheets;
  const rest = others.map((sheet) => ({ ...sheet, page: { ...sheet.page, words: wordsOf(sheet) } }));
  return [{ ...cover, page: { ...cover.page, words: wordsOf(cover) } }, ...rest];
}

/**
 * Returns the dates of photos in the format of the user. If the photos have several years, the first day of each has it.
 * @param times local times in milliseconds, as if they were UTC
 */
function datesOf(times: readonly (number | null)[]): BookDates {
  const starts = times.filter((time) => time !== null).map((time) => Math.floor((time - MORNING) / DAY) * DAY);
  const known = [...new Set(starts)].toSorted((a, b) => a - b);
  if (known.length === 0) return {};
  const [first, last] = [known[0], known[known.length - 1]];
  const yearOf = (time: number) => new Date(time).getUTCFullYear();
  const isNew = (time: number, i: number) =>
    yearOf(first) !== yearOf(last) && yearOf(time) !== yearOf(known[i - 1] ?? NaN);
  const days = known.map((time, i) => [
    new Date(time).toISOString().slice(0, 10),
    isNew(time, i) ? strings.dates(time, time) : strings.shortDayOf(time),
  ]);
  return { span: strings.dates(first, last), days: Object.fromEntries(days) };
}
