import { describe, expect, it } from 'vitest';
import { LIVING, livingTimes } from './living.ts';

const COUNT = LIVING.rate * LIVING.seconds;

describe('the pictures of a panel that moves', () => {
  it('lie about its photo', () => {
    const { times, still } = livingTimes({ time: 10, duration: 60 });
    expect(times).toHaveLength(COUNT);
    expect(times[0]).toBeCloseTo(10 - LIVING.seconds / 2);
    expect(times[still]).toBeCloseTo(10);
  });

  it('stay inside of the film, at its beginning, at its end and where it is short', () => {
    expect(livingTimes({ time: 0.1, duration: 60 })).toMatchObject({ still: 1 });
    expect(livingTimes({ time: 0.1, duration: 60 }).times[0]).toBe(0);
    const end = livingTimes({ time: 59.9, duration: 60 });
    expect(end.times.every((time) => time < 60)).toBe(true);
    expect(end.times).toHaveLength(COUNT);
    expect(end.still).toBe(COUNT - 1);
    const short = livingTimes({ time: 0.5, duration: 1 });
    expect(short.times).toHaveLength(LIVING.rate);
    expect(short.times[short.still]).toBeCloseTo(0.5);
  });
});
