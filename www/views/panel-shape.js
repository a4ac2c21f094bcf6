// @ts-check
/** Where panels are on the page: for the elements that stand for them, and for the arrow keys. */

/** @typedef {import('../engine/documents.js').Geometry['panels'][number]} PanelShape */

/**
 * @param {PanelShape} panel
 * @param {number} height of the page, in its widths
 */
export function place({ bounds, polygon, circle }, height) {
  const percent = (/** @type {number} */ part) => `${(part * 100).toFixed(3)}%`;
  const points = (polygon ?? []).map(([x, y]) => (
    `${percent((x - bounds.x) / bounds.width)} ${percent((y - bounds.y) / bounds.height)}`
  ));
  return {
    left: percent(bounds.x),
    top: percent(bounds.y / height),
    width: percent(bounds.width),
    height: percent(bounds.height / height),
    // A slanted panel is hit where it is, not where its box is.
    clipPath: circle ? 'circle(50%)' : `polygon(${points.join(', ')})`,
  };
}

/** @type {Record<string, [number, number]>} */
export const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * The nearest panel in a direction; sideways distance counts double.
 * @param {PanelShape[]} panels
 * @param {number} from
 * @param {[number, number]} way
 * @returns {number} `from` itself when there is none
 */
export function neighbour(panels, from, [wayX, wayY]) {
  const centre = (/** @type {PanelShape} */ { bounds }) => [bounds.x + bounds.width / 2, bounds.y + bounds.height / 2];
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
