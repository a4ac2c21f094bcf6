/** Preserved ranges of a file. Everything else is removed. */

/** From the first byte to the byte after the last. */
export type Range = readonly [from: number, to: number];

/** @returns in order, without overlaps */
export function joined(ranges: readonly Range[]): [from: number, to: number][] {
  const all: [number, number][] = [];
  for (const [from, to] of [...ranges].sort((one, other) => one[0] - other[0])) {
    if (to <= from) continue;
    const last = all.at(-1);
    if (last && from <= last[1]) last[1] = Math.max(last[1], to);
    else all.push([from, to]);
  }
  return all;
}

/**
 * Blanks everything outside the ranges.
 * @param bytes are changed
 * @param within default: the whole file
 */
export function blankAround(bytes: Uint8Array, ranges: readonly Range[], [start, end]: Range = [0, bytes.length]) {
  let at = start;
  for (const [from, to] of joined(ranges)) {
    if (from > at) bytes.fill(0, at, Math.min(from, end));
    at = Math.max(at, to);
  }
  if (at < end) bytes.fill(0, at, end);
}

/** @returns whether a byte is in both */
export function meet(ranges: readonly Range[], others: readonly Range[]): boolean {
  const [one, other] = [joined(ranges), joined(others)];
  for (let i = 0, j = 0; i < one.length && j < other.length; ) {
    if (one[i][0] < other[j][1] && other[j][0] < one[i][1]) return true;
    if (one[i][1] < other[j][1]) i += 1;
    else j += 1;
  }
  return false;
}
