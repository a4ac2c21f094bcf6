import { expect, test } from 'vitest';
import { albumName, albumTitle, isDates } from './album-name.ts';
import { numbersIn } from '../strings/numbers.ts';
import type { Origin } from './album-name.ts';

const NOW = Date.UTC(2026, 10, 24);
const { dates } = numbersIn('en-GB');

const photo = (origin: Partial<Origin> = {}): Origin => ({
  folders: [],
  taken: null,
  modified: () => null,
  ...origin,
});
const named = (...origins: Origin[]) => albumName(origins, { samples: 'Sample album', dates, now: NOW });

test('an album is called after the folder that all of it came in', () => {
  expect(named(photo({ folders: ['Lisbon'] }), photo({ folders: ['Lisbon'] }))).toBe('Lisbon');
  expect(named(photo({ folders: ['Lisbon', 'day 1'] }), photo({ folders: ['Lisbon', 'day 2'] }))).toBe('Lisbon');
  expect(named(photo({ folders: ['Trip', 'Lisbon'] }), photo({ folders: ['Trip', 'Lisbon'] }))).toBe('Lisbon');
  // Folder names of cameras are ignored.
  expect(named(photo({ folders: ['Lisbon', 'DCIM', '100CANON'] }))).toBe('Lisbon');
  expect(named(photo({ folders: ['Downloads'], taken: '2026:06:03 10:00:00' }))).toBe('3 June 2026');
  const one = photo({ taken: '2026:06:03 10:00:00' });
  expect(named(one, photo({ folders: ['Lisbon'], taken: '2026:06:03 12:00:00' }))).toBe('3 June 2026');
});

test('else after its days, in the form of the language', () => {
  const taken = (day: string) => photo({ taken: `${day} 12:00:00` });
  expect(named(taken('2026:06:03'), taken('2026:06:05'), taken('2026:06:04'))).toBe('3 – 5 June 2026');
  expect(named(taken('2026:05:30'), taken('2026:06:02'))).toBe('30 May – 2 June 2026');
  expect(named(taken('2026:01:03'), taken('2026:08:20'))).toBe('January – August 2026');
  expect(named(taken('2019:01:03'), taken('2026:08:20'))).toBe('2019 – 2026');
  const of = (locale: string) => numbersIn(locale).dates(Date.UTC(2026, 5, 3), Date.UTC(2026, 5, 5));
  expect(of('de')).toBe('3.–5. Juni 2026');
  expect(of('ja')).toBe('2026年6月3日 – 2026年6月5日');
  expect(of('en-US')).toBe('June 3 – 5, 2026');
});

test('clocks that were never set, and ranks in the place of times, are no days', () => {
  expect(named(photo({ taken: '0000:00:00 00:00:00' }), photo({ taken: '000000003' }))).toBe('');
  expect(named(photo({ taken: '1980:01:01 00:00:00' }), photo({ taken: '2026:06:03 10:00:00' }))).toBe('3 June 2026');
  expect(named(photo({ taken: '2062:06:03 10:00:00' }), photo({ taken: '2026:06:03 10:00:00' }))).toBe('3 June 2026');
});

test('times of files count where cameras are silent', () => {
  const modified = () => new Date(2026, 5, 9, 23, 30).getTime();
  expect(named(photo({ modified }), photo({ modified }))).toBe('9 June 2026');
  expect(named(photo({ modified }), photo({ taken: '2026:06:03 10:00:00' }))).toBe('3 June 2026');
  expect(named(photo())).toBe('');
  expect(named()).toBe('');
});

test.each(['en-US', 'en-GB', 'de', 'es', 'fr', 'pt', 'ja'])('a name of dates is recognised in %s', (locale) => {
  const format = numbersIn(locale).dates;
  const day = Date.UTC(2026, 10, 29);
  for (const days of [0, 2, 40, 100, 900]) expect(isDates(format(day, day + days * 86_400_000), format)).toBe(true);
  for (const name of ['Summer', 'Summer 2026', 'Lisbon, 3', '']) expect(isDates(name, format)).toBe(false);
});

test('the samples are called so', () => {
  expect(named(photo({ sample: true }), photo({ sample: true }))).toBe('Sample album');
  expect(named(photo({ sample: true }), photo({ taken: '2026:06:03 10:00:00' }))).toBe('3 June 2026');
});

test('a page has the days of one event as its title', () => {
  const titled = (...taken: (string | null)[]) =>
    albumTitle(
      taken.map((day) => photo({ taken: day && `${day} 12:00:00`, modified: () => NOW })),
      { samples: 'Sample album', dates, now: NOW },
    );
  expect(titled('2026:06:03', '2026:06:05', null)).toBe('3 – 5 June 2026');
  // Most photos are undated.
  expect(titled('2026:06:03', null)).toBe('');
  expect(titled('2019:01:03', '2026:08:20')).toBe('');
  expect(titled(null)).toBe('');
});
