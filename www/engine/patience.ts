/**
 * A time limit that ignores the time when the device sleeps or the tab is frozen. After a freeze timers fire late and
 * all at once, although no work was possible. So the limit is cut into parts that begin one after the other.
 */

const PARTS = 6;

/**
 * @param limit ms
 * @param over called after the limit
 * @returns ends the limit; call it when the work is done
 */
export function patience(limit: number, over: () => void): () => void {
  let left = PARTS;
  let timer: ReturnType<typeof setTimeout>;
  const next = () => {
    timer = setTimeout(() => {
      left -= 1;
      if (left > 0) next();
      else over();
    }, limit / PARTS);
  };
  next();
  return () => clearTimeout(timer);
}
