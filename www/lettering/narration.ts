/**
 * The title and the captions that Shuffle adds to a page: the name of the album, and when and where photos were taken. They
 * are marked `made`, so the next shuffle replaces them. An edit removes the mark.
 */

import { isOneEvent } from '../photos/album-name.ts';
import type { PageDocument, Word } from '../engine/types.ts';

/** When and where a photo was taken. `at` is the local time in milliseconds, as if it were UTC; null if unknown. */
export type Moment = { at: number | null; place: string };

export type Narration = {
  /** The title of the page. An empty title adds no title item. */
  title: string;
  /** By photo id. */
  moments: ReadonlyMap<string, Moment>;
  language: string;
  day: (at: number) => string;
  time: (at: number) => string;
};

/** Captions on a page at most, besides the title. */
const MOST_CAPTIONS = 2;
const HOUR = 3_600_000;
/** A shorter time between two panels gets no caption. */
const LEAST_GAP = 3 * HOUR;
/** Height of an em of the title, in page widths. */
const TITLE_SIZE = 0.04;
/** Width of a capital letter in ems, padding of the text, and maximum width of a title, in page widths. */
const [LETTER, PADDING, WIDEST_TITLE] = [0.7, 0.03, 0.8];

/** @returns the page without the text that an earlier shuffle added. The text of a book stays. */
export function plain(page: PageDocument): PageDocument {
  const words = page.words ?? [];
  const own = words.filter(({ made, book }) => !made || book);
  return own.length === words.length ? page : { ...page, words: own };
}

/**
 * Adds a title and captions to a planned page.
 * @returns the page itself if there is nothing to add or to remove
 */
export function narrated(page: PageDocument, narration: Narration): PageDocument {
  const clean = plain(page);
  const own = clean.words ?? [];
  // The user's own text tells the story.
  if (own.length > 0) return clean;
  const photos = page.panels.map(({ photo }) => photo ?? '');
  const made = [...titleOf(photos, narration), ...captionsOf(photos, narration)];
  return made.length === 0 ? clean : { ...clean, words: [...own, ...made] };
}

function titleOf(photos: readonly string[], { title, language }: Narration): Word[] {
  if (title === '' || photos.length === 0) return [];
  const width = Math.min(WIDEST_TITLE, title.length * TITLE_SIZE * LETTER + PADDING);
  return [{ ...word(title, 0, photos, language), size: TITLE_SIZE, width, capitals: true }];
}

/** Captions on the panels at which the day, the place or the time changes most. */
function captionsOf(photos: readonly string[], { title, moments, language, day, time }: Narration): Word[] {
  const steps: { panel: number; text: string; gap: number }[] = [];
  let before = null as number | null;
  const seen = new Set<string>();
  const places = new Set<string>();
  // The date of one photo could be mistaken for the date of the page, if the other photos have no date or span many
  // years.
  const showsTimes = isOneEvent([...new Set(photos)].map((photo) => moments.get(photo)?.at ?? null));
  for (const [panel, photo] of photos.entries()) {
    const moment = moments.get(photo);
    if (!moment || seen.has(photo)) continue;
    const isFirst = seen.size === 0;
    seen.add(photo);
    const now = showsTimes ? moment.at : null;
    const { place } = moment;
    // Captions tell time in one direction.
    if (before !== null && now !== null && now < before) return [];
    if (isFirst) {
      const text = title === '' ? [now === null ? '' : day(now), place].filter((part) => part !== '').join(' · ') : '';
      if (text !== '') steps.push({ panel, text, gap: Number.POSITIVE_INFINITY });
    } else if (place !== '' && !places.has(place)) {
      steps.push({ panel, text: place, gap: Number.MAX_VALUE });
    } else if (before !== null && now !== null && now - before >= LEAST_GAP) {
      const sameDay = Math.floor(before / (24 * HOUR)) === Math.floor(now / (24 * HOUR));
      steps.push({ panel, text: sameDay ? time(now) : day(now), gap: now - before });
    }
    places.add(place);
    before = now ?? before;
  }
  return steps
    .sort((a, b) => b.gap - a.gap)
    .slice(0, MOST_CAPTIONS)
    .sort((a, b) => a.panel - b.panel)
    .map(({ panel, text }) => word(text, panel, photos, language));
}

function word(text: string, panel: number, photos: readonly string[], language: string): Word {
  return { kind: 'caption', text, panel, photo: photos[panel], auto: true, made: true, language };
}
