/** Positions of panels on the page: for their elements, and for the arrow keys. */

import type { Geometry } from '../../engine/types.ts';

export type PanelShape = Geometry['panels'][number];

/** @param height of the page, in its widths */
export function place({ bounds, polygon, circle }: PanelShape, height: number) {
  const percent = (part: number) => `${(part * 100).toFixed(3)}%`;
  const points = (polygon ?? []).map(
    ([x, y]) => `${percent((x - bounds.x) / bounds.width)} ${percent((y - bounds.y) / bounds.height)}`,
  );
  return {
    left: percent(bounds.x),
    top: percent(bounds.y / height),
    width: percent(bounds.width),
    height: percent(bounds.height / height),
    // A click hits the slanted shape, not its bounding box.
    clipPath: circle ? 'circle(50%)' : `polygon(${points.join(', ')})`,
  };
}

export const WAYS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/**
 * The nearest panel in a direction; sideways distance counts double.
 * @returns `from` without a neighbour in this direction
 */
export function neighbour(panels: readonly PanelShape[], from: number, [wayX, wayY]: [number, number]): number {
  const centre = ({ bounds }: PanelShape) => [bounds.x + bounds.width / 2, bounds.y + bounds.height / 2];
  const [x, y] = centre(panels[from]);
  let best = from;
  let least = Infinity;
  panels.forEach((panel, i) => {
    const [otherX, otherY] = centre(panel);
    const along = (otherX - x) * wayX + (otherY - y) * wayY;
    const across = Math.abs((otherX - x) * wayY) + Math.abs((otherY - y) * wayX);
    const distance = along + 2 * across;
    if (i !== from && along > 1e-6 && distance < least) {
      best = i;
      least = distance;
    }
  });
  return best;
}
