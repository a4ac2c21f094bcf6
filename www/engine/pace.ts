/**
 * Time limits for work with a known duration on a reference machine. The speed of this device is measured with its
 * work. So a phone gets enough time, and a hanging worker on a fast machine is found soon.
 */

import { SHARES_CODE } from './shared-code.ts';

/** Initial slowdown factor, until a measurement exists. */
const FIRST = 4;
/** Lower bound of the slowdown factor. */
const LEAST = 1;
const MOST = 20;
/** Milliseconds of work that is too short to measure, because the clock and messages dominate. */
const TOO_SHORT = 20;
/**
 * Fixed allowance in ms for messaging and garbage collection. A worker that compiles its code may wait several seconds
 * first.
 */
const REST = SHARES_CODE ? 3_000 : 12_000;
/** Time limit of work, as a multiple of its expected duration on this device. */
const MARGIN = 4;

export function createPace() {
  let pace = FIRST;

  return {
    /**
     * @param expected milliseconds in the reference measurement
     * @returns ms to wait for it here
     */
    patience: (expected: number): number => REST + MARGIN * pace * expected,

    /**
     * @param expected ms
     * @param ms measured milliseconds
     */
    took(expected: number, ms: number) {
      if (expected < TOO_SHORT) return;
      const now = Math.min(MOST, Math.max(LEAST, ms / expected));
      pace = now > pace ? now : pace + (now - pace) / 4;
    },
  };
}
