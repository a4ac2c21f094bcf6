// @ts-check

/**
 * Times spread evenly over a stretch of a video, each in the middle of its share: `t = start + (i + .5) / n * length`.
 * @param {{ first: number, duration: number, count: number, start?: number, end?: number }} stretch seconds; `first`
 *   is when the first frame is shown, `duration` when the last one ends
 * @returns {number[]} seconds, rising, all within the video
 */
export function sampleTimes({ first, duration, count, start = 0, end = Infinity }) {
  const from = Math.min(Math.max(first, start), duration);
  const to = Math.max(from, Math.min(duration, end));
  return Array.from({ length: Math.max(1, Math.floor(count)) }, (_, i) => from + (i + 0.5) / count * (to - from));
}
