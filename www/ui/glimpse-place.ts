/** Position of a preview: close to its control, inside the window, and not over the control if there is space. */

export type Box = { left: number; top: number; width: number; height: number };
export type Size = { width: number; height: number };

/** Distance from the control and from the edges of the window, in CSS pixels. */
export const GAP = 12;
/** Below this width it shows no more than the thumbnail. */
const LEAST = 160;

/** Inside the free area and as near to the control as possible. */
export function inside(at: Box, size: Size, room: Box): Box {
  const by = Math.min(1, (room.width - 2 * GAP) / size.width, (room.height - 2 * GAP) / size.height);
  const [width, height] = [size.width * by, size.height * by];
  return {
    width,
    height,
    left: room.left + within(at.left + at.width / 2 - width / 2 - room.left, width, room.width),
    top: room.top + within(at.top + at.height / 2 - height / 2 - room.top, height, room.height),
  };
}

/** On the side of the control with the most space: right, left, above or below. */
export function beside(at: Box, size: Size, window: Size): Box {
  const sideways = Math.max(at.left, window.width - at.left - at.width) - 2 * GAP;
  const upright = Math.max(at.top, window.height - at.top - at.height) - 2 * GAP;
  const scale = (width: number, height: number) => Math.min(1, width / size.width, height / size.height);
  const [room, tall] = [window.width - 2 * GAP, window.height - 2 * GAP];
  const [aside, over] = [scale(sideways, tall), scale(room, upright)];
  const best = Math.max(aside, over);
  // If neither side has space for more than a thumbnail, the preview covers its control.
  const fits = best * size.width >= Math.min(LEAST, size.width);
  const by = fits ? best : scale(room, tall);
  const [width, height] = [size.width * by, size.height * by];
  const middle = {
    left: within(at.left + at.width / 2 - width / 2, width, window.width),
    top: within(at.top + at.height / 2 - height / 2, height, window.height),
  };
  if (!fits) return { width, height, ...middle };
  if (aside >= over) {
    const right = at.left + at.width + GAP + width + GAP <= window.width;
    return { width, height, top: middle.top, left: right ? at.left + at.width + GAP : at.left - GAP - width };
  }
  const above = at.top - GAP - height >= GAP - 0.5;
  return { width, height, left: middle.left, top: above ? at.top - GAP - height : at.top + at.height + GAP };
}

function within(place: number, size: number, whole: number) {
  return Math.max(GAP, Math.min(place, whole - size - GAP));
}
