/** The time left of a task, from its speed in the last seconds. */

/** No estimate before this time, in milliseconds: the first steps of a task are often slower. */
const FIRST = 3000;
/** The speed is measured over this time, in milliseconds. */
const WINDOW = 15_000;
/** Seconds are rounded up to a multiple of this number. */
const STEP = 5;

/** Returns a function that takes the progress of a task. It returns the seconds left, or null if they are unknown. */
export function createTimeLeft(now: () => number) {
  const start = now();
  const seen = [{ at: start, part: 0 }];

  return (done: number, total: number): number | null => {
    const last = { at: now(), part: total > 0 ? done / total : 0 };
    seen.push(last);
    // One older measurement stays, so that the window is always covered.
    while (seen[1].at < last.at - WINDOW) seen.shift();
    const [first] = seen;
    if (last.at - start < FIRST || last.part <= first.part || last.part >= 1) return null;
    const left = ((1 - last.part) * (last.at - first.at)) / (last.part - first.part);
    return Math.ceil(left / 1000 / STEP) * STEP;
  };
}
