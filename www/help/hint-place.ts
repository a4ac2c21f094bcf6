/** Position of a hint: next to its subject, and over no control and no message. */

export type Box = { left: number; top: number; width: number; height: number };
export type Side = 'above' | 'below' | 'after' | 'before';
/** `x` and `y`: its corner; `tail`: where along its edge it points, in pixels from the corner */
export type Place = { x: number; y: number; side: Side; tail: number | null };

/** Distances from the subject, with space for the tail. Larger ones skip controls in between, without a tail. */
const GAPS = [12, 64, 116, 168, 220, 260, 300];
/** Room at the edges of the window. */
const EDGE = 8;
/** Distance between candidate positions if there is no position next to the subject. */
const STEP = 16;
/** Minimum distance of the tail from the round corners. */
const ROUND = 20;
/** Candidate offsets along the edge of the subject, as shares of the hint's length: centred first. */
const SHIFTS = [0.5, 0.25, 0.75, 0.1, 0.9];

/**
 * @param anchor the subject of the hint
 * @param size its own
 * @param room where it may be
 * @param taken `controls`: must stay uncovered, or at least their centres; `messages`: must stay uncovered
 * @param sides the best first
 * @returns null if there is no such position
 */
export function placeHint(
  anchor: Box,
  size: { width: number; height: number },
  room: Box,
  { controls, messages }: { controls: readonly Box[]; messages: readonly Box[] },
  sides: readonly Side[],
): Place | null {
  const places = GAPS.flatMap((gap) =>
    sides.flatMap((side) => SHIFTS.map((shift) => placeAt(anchor, size, room, { gap, side, shift }))),
  ).filter(({ x, y }) => {
    const box = { left: x, top: y, ...size };
    return within(box, room) && !messages.some((other) => touch(box, other));
  });
  const middles = controls.map(({ left, top, width, height }) => ({
    left: left + width / 2,
    top: top + height / 2,
    width: 0,
    height: 0,
  }));
  const clear = (of: readonly Box[], among: readonly Place[] = places) =>
    among.find(({ x, y }) => !of.some((other) => touch({ left: x, top: y, ...size }, other)));
  return clear(controls) ?? clear(middles) ?? clear([...middles, ...messages], anywhere(anchor, size, room)) ?? null;
}

/** Candidates without space next to the subject: anywhere, the closest to its lower edge first. */
function anywhere(anchor: Box, { width, height }: { width: number; height: number }, room: Box): Place[] {
  const places: Place[] = [];
  for (let y = room.top + EDGE; y + height <= room.top + room.height - EDGE; y += STEP)
    for (let x = room.left + EDGE; x + width <= room.left + room.width - EDGE; x += STEP)
      places.push({ x, y, side: 'above', tail: null });
  const [middle, foot] = [anchor.left + anchor.width / 2, anchor.top + anchor.height];
  const far = ({ x, y }: Place) => Math.hypot(x + width / 2 - middle, y + height / 2 - foot);
  return places.sort((a, b) => far(a) - far(b));
}

function placeAt(
  anchor: Box,
  { width, height }: { width: number; height: number },
  room: Box,
  { gap, side, shift }: { gap: number; side: Side; shift: number },
): Place {
  const [middleX, middleY] = [anchor.left + anchor.width / 2, anchor.top + anchor.height / 2];
  const upright = side === 'above' || side === 'below';
  const x = upright
    ? clamp(middleX - width * shift, room.left + EDGE, room.left + room.width - width - EDGE)
    : side === 'after'
      ? anchor.left + anchor.width + gap
      : anchor.left - width - gap;
  const y = !upright
    ? clamp(middleY - height * shift, room.top + EDGE, room.top + room.height - height - EDGE)
    : side === 'below'
      ? anchor.top + anchor.height + gap
      : anchor.top - height - gap;
  const along = clamp(upright ? middleX - x : middleY - y, ROUND, (upright ? width : height) - ROUND);
  return { x, y, side, tail: gap === GAPS[0] ? along : null };
}

const clamp = (value: number, least: number, most: number) => Math.min(Math.max(value, least), Math.max(least, most));

const within = ({ left, top, width, height }: Box, room: Box) =>
  left >= room.left + EDGE &&
  top >= room.top + EDGE &&
  left + width <= room.left + room.width - EDGE &&
  top + height <= room.top + room.height - EDGE;

const touch = (a: Box, b: Box) =>
  a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
