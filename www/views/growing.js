// @ts-check
/** Long lists that are shown a piece at a time, so that the page answers between the pieces. */

import { useEffect, useState } from 'preact/hooks';

/** What is drawn in one task: well below 50 ms, and more than a screen shows at first. */
const PIECE = 24;

/**
 * How many of so many items to show now; all of them some frames later.
 * @param {number} total
 * @returns {number}
 */
export function useGrowing(total) {
  const [room, setRoom] = useState(PIECE);
  useEffect(() => {
    // A list that was emptied begins again.
    if (total === 0) setRoom(PIECE);
    if (room >= total) return undefined;
    let task = /** @type {ReturnType<typeof setTimeout> | undefined} */ (undefined);
    // After the frame that shows the last piece.
    const frame = requestAnimationFrame(() => { task = setTimeout(() => setRoom(room + PIECE)); });
    return () => {
      cancelAnimationFrame(frame);
      clearTimeout(task);
    };
  }, [room, total]);
  return Math.min(room, total);
}
