import { describe, expect, it } from 'vitest';
import { runs, sampleTimes } from './sample-times.ts';

describe('the times of frames', () => {
  it('are in the middle of equal shares, within the film', () => {
    expect(sampleTimes({ first: 0, duration: 12, count: 3 })).toEqual([2, 6, 10]);
    expect(sampleTimes({ first: 1, duration: 5, count: 2, start: 0, end: 99 })).toEqual([2, 4]);
  });

  it('come in two runs where some are waited for, else in one', () => {
    expect(runs(4)).toEqual([[0, 1, 2, 3]]);
    expect(runs(5, [3, 1])).toEqual([
      [1, 3],
      [0, 2, 4],
    ]);
    expect(runs(2, [0, 1])).toEqual([[0, 1]]);
  });
});
