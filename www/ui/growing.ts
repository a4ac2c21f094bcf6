/** Long lists whose items are made a few at a time, so that the page answers in between. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { createTimer } from '../engine/scheduler.ts';

/** Items per task: well below 50 ms, and more than the first screen shows. */
const PIECE = 24;

/**
 * Items to show now: the old ones and some of the new ones. A few frames later all items are shown.
 * @param keys of all items, in order
 */
export function useGrowing(keys: readonly string[]): ReadonlySet<string> {
  const last = useRef(new Set() as ReadonlySet<string>);
  const [, again] = useState(0);
  let room = PIECE;
  const shown = new Set(keys.filter((key) => last.current.has(key) || (room -= 1) >= 0));
  useEffect(() => {
    last.current = shown;
    if (shown.size === keys.length) return undefined;
    const timer = createTimer();
    // After the frame that shows this piece.
    const frame = requestAnimationFrame(() => timer.start(0, () => again((n) => n + 1)));
    return () => {
      cancelAnimationFrame(frame);
      timer.stop();
    };
  });
  return shown;
}
