/** The time left of a task, from its speed in the last seconds. */

/** No estimate before the speed was measured over this time, in milliseconds, and over this part of the task. */
const LEAST = { time: 3000, part: 0.03 };
/** The speed is measured over this time, in milliseconds. */
const WINDOW = 15_000;
/** Seconds are rounded up to a multiple of this number. */
const STEP = 5;

/** Returns a function that takes the progress of a task. It returns the seconds left, or null if they are unknown. */
export function createTimeLeft(now: () => number) {
  const seen = [{ at: now(), part: 0 }];

  return (done: number, total: number): number | null => {
    const last = { at: now(), part: total > 0 ? done / total : 0 };
    // The first step does not count, because it includes the start of workers.
    if (seen[0].part === 0 && last.part > 0) seen.length = 0;
    seen.push(last);
    // One older measurement stays, so that the window is always covered.
    while (seen[1]?.at < last.at - WINDOW) seen.shift();
    const [first] = seen;
    const [time, part] = [last.at - first.at, last.part - first.part];
    if (time < LEAST.time || part < LEAST.part || last.part >= 1) return null;
    return Math.ceil(((1 - last.part) * time) / part / 1000 / STEP) * STEP;
  };
}
