import { expect, test } from 'vitest';
import { createFilmClock } from './film-clock.ts';
import { sampleTimes } from './sample-times.ts';

test('a film starts with its first picture, whatever the time of that picture in the file', () => {
  const { inFilm, wishInFile } = createFilmClock(11.4);
  expect(inFilm(11.4)).toBe(0);
  expect(inFilm(12.36)).toBeCloseTo(0.96, 9);
  // A decoded picture that is not shown.
  expect(inFilm(11.3)).toBe(0);
  const { times, moments, start, end, count, leading } = wishInFile({
    count: 2,
    leading: [1],
    start: 1,
    end: 4,
    times: [0, 0.96],
    moments: [9],
  });
  expect([count, leading]).toEqual([2, [1]]);
  expect([start, end]).toEqual([12.4, 15.4]);
  expect(times?.map(inFilm).map((time) => Math.round(time * 1e6) / 1e6)).toEqual([0, 0.96]);
  expect(moments).toEqual([20.4]);
});

test('a stretch of a film gives the same frames in a file with another first time', () => {
  const plain = sampleTimes({ first: 0, duration: 12, count: 3, start: 2, end: 8 });
  const { inFilm, wishInFile } = createFilmClock(11.4);
  const late = sampleTimes({ ...wishInFile({ count: 3, start: 2, end: 8 }), first: 11.4, duration: 23.4 });
  expect(late.map(inFilm).map((time) => time.toFixed(6))).toEqual(plain.map((time) => time.toFixed(6)));
});

test('what is not asked for stays so', () => {
  const wish = createFilmClock(5).wishInFile({ count: 0, shots: true });
  expect(wish).toMatchObject({ count: 0, shots: true });
  expect([wish.start, wish.end, wish.times, wish.moments]).toEqual([undefined, undefined, undefined, undefined]);
});
