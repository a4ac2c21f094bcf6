import { expect, test } from 'vitest';
import { narrated, plain } from './narration.ts';
import type { Moment, Narration } from './narration.ts';
import type { PageDocument, Word } from '../engine/types.ts';

const pageOf = (photos: string[], words: Word[] = []) =>
  ({ panels: photos.map((photo) => ({ photo })), words }) as unknown as PageDocument;

const at = (text: string) => Date.parse(`${text}Z`);

function narration(moments: Record<string, Partial<Moment>>, title = 'Lisbon'): Narration {
  return {
    title,
    moments: new Map(Object.entries(moments).map(([id, moment]) => [id, { at: null, place: '', ...moment }])),
    language: 'en',
    day: (time) => new Date(time).toISOString().slice(0, 10),
    time: (time) => new Date(time).toISOString().slice(11, 16),
  };
}

const told = (page: PageDocument) => page.words?.map(({ panel, text }) => [panel, text]);

test('a page gets the title on its first panel', () => {
  const page = narrated(pageOf(['a', 'b']), narration({}));
  expect(told(page)).toEqual([[0, 'Lisbon']]);
  expect(page.words?.[0]).toMatchObject({ kind: 'caption', made: true, auto: true, photo: 'a' });
});

test('the two largest jumps in time get captions, with the day or the time', () => {
  const moments = {
    a: { at: at('2026-06-01T09:00') },
    b: { at: at('2026-06-01T10:00') },
    c: { at: at('2026-06-01T20:30') },
    d: { at: at('2026-06-03T08:00') },
    e: { at: at('2026-06-03T12:00') },
  };
  const page = narrated(pageOf(['a', 'b', 'c', 'd', 'e']), narration(moments));
  expect(told(page)).toEqual([
    [0, 'Lisbon'],
    [2, '20:30'],
    [3, '2026-06-03'],
  ]);
});

test('without a title the first panel says the day, and another folder is a place', () => {
  const moments = {
    a: { at: at('2026-06-01T09:00'), place: 'Sintra' },
    b: { at: at('2026-06-01T10:00'), place: 'Cascais' },
  };
  const page = narrated(pageOf(['a', 'b']), narration(moments, ''));
  expect(told(page)).toEqual([
    [0, '2026-06-01 · Sintra'],
    [1, 'Cascais'],
  ]);
});

test('a page names a place once', () => {
  const places = ['Porto', '', 'Porto', 'Faro', 'Porto'];
  const moments = Object.fromEntries(places.map((place, i) => [`p${i}`, { place }]));
  const page = narrated(pageOf(Object.keys(moments)), narration(moments, ''));
  expect(told(page)).toEqual([
    [0, 'Porto'],
    [3, 'Faro'],
  ]);
});

test('photos that are not in the order of time get no captions', () => {
  const moments = { a: { at: at('2026-06-02T09:00') }, b: { at: at('2026-06-01T10:00') } };
  expect(told(narrated(pageOf(['a', 'b']), narration(moments, '')))).toEqual([]);
});

test('text of an earlier shuffle is replaced, and text of a person keeps the page as it is', () => {
  const first = narrated(pageOf(['a', 'b']), narration({}));
  const again = narrated({ ...first, panels: pageOf(['b', 'a']).panels }, narration({}));
  expect(again.words).toHaveLength(1);
  expect(again.words?.[0].photo).toBe('b');
  const own: Word = { kind: 'balloon', text: 'Hi', panel: 0 };
  expect(told(narrated({ ...first, words: [...(first.words ?? []), own] }, narration({})))).toEqual([[0, 'Hi']]);
  const empty = pageOf(['a']);
  expect(plain(empty)).toBe(empty);
});

test('undated photos, and photos of many years, leave a page without days', () => {
  const dated = { a: { at: at('2026-06-01T09:00') } };
  expect(told(narrated(pageOf(['a', 'b', 'c']), narration(dated, '')))).toEqual([]);
  const years = { a: { at: at('2019-06-01T09:00') }, b: { at: at('2026-06-01T10:00') } };
  expect(told(narrated(pageOf(['a', 'b']), narration(years, '')))).toEqual([]);
});

test('the text of a book stays, and nothing is added to it', () => {
  const title: Word = { kind: 'caption', text: 'Second day.', panel: 0, made: true, book: true };
  const page = { ...pageOf(['a']), words: [title] };
  expect(narrated(page, narration({})).words).toEqual([title]);
  expect(plain(page)).toBe(page);
});
