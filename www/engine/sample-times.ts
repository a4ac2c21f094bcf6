/**
 * Times spread evenly over a stretch of a video, each in the middle of its share: `t = start + (i + .5) / n * length`.
 * @param stretch seconds; `first`
 *   is when the first frame is shown, `duration` when the last one ends
 * @returns seconds, rising, all within the video
 */
export function sampleTimes({
  first,
  duration,
  count,
  start = 0,
  end = Infinity,
}: {
  first: number;
  duration: number;
  count: number;
  start?: number;
  end?: number;
}): number[] {
  const from = Math.min(Math.max(first, start), duration);
  const to = Math.max(from, Math.min(duration, end));
  return Array.from({ length: Math.max(1, Math.floor(count)) }, (_, i) => from + ((i + 0.5) / count) * (to - from));
}

/**
 * The order of frame extraction: urgent frames first, each group in order of time, because videos are decoded forwards.
 * @param leading the indices of the urgent frames
 * @returns the indices of all frames, as one or two passes through the video
 */
export function runs(count: number, leading: readonly number[] = []): number[][] {
  const all = Array.from({ length: count }, (_, i) => i);
  return [all.filter((i) => leading.includes(i)), all.filter((i) => !leading.includes(i))].filter(
    (run) => run.length > 0,
  );
}
