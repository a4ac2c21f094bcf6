/**
 * A time limit that a sleeping device and a tab frozen in the background do not use up: their timers fire late and all
 * at once, while nobody had the time to work. So the limit is cut into parts that begin one after the other.
 */

const PARTS = 6;

/**
 * @param limit ms
 * @param over what to do when it has passed
 * @returns call it when there is nothing left to wait for
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
