/**
 * How long to wait for work of which it is known how long it took where it was measured. How much slower this device is
 * shows with the work that it does: a telephone is given its time, and on a quick machine a worker that hangs is soon
 * found out.
 */

import { SHARES_CODE } from './shared-code.ts';

/** Times as long as measured, until it is known better. */
const FIRST = 4;
/** Never less: what is busy now and then is no slower than it was. */
const LEAST = 1;
const MOST = 20;
/** In ms: of shorter work the clock and the messages are as much as the work. */
const TOO_SHORT = 20;
/**
 * Milliseconds for what is no work: messages on their way, a browser that tidies up. A worker that compiles the code for
 * itself may first wait seconds for that.
 */
const REST = SHARES_CODE ? 3_000 : 12_000;
/** Work that takes this many times as long as work took here is given up. */
const MARGIN = 4;

export function createPace() {
  let pace = FIRST;

  return {
    /**
     * @param expected ms where it was measured
     * @returns ms to wait for it here
     */
    patience: (expected: number): number => REST + MARGIN * pace * expected,

    /**
     * @param expected ms
     * @param ms that it took here
     */
    took(expected: number, ms: number) {
      if (expected < TOO_SHORT) return;
      const now = Math.min(MOST, Math.max(LEAST, ms / expected));
      pace = now > pace ? now : pace + (now - pace) / 4;
    },
  };
}
