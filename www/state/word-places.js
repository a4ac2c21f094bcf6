// @ts-check
/** Places of words: fractions of a panel, or of the page, and back to page widths. */

import { MOST } from './limits.js';

/** @typedef {import('../engine/documents.js').Geometry} Geometry */
/** @typedef {import('../engine/documents.js').Bounds} Bounds */
/** @typedef {import('../engine/documents.js').Word} Word */
/** @typedef {[number, number]} Place */

/**
 * What the places of a word are fractions of.
 * @param {Geometry} geometry
 * @param {Pick<Word, 'panel'>} word
 * @returns {Bounds} in page widths
 */
export function frameOf({ panels, height }, { panel }) {
  const own = panel === null || panel === undefined ? undefined : (panels[panel] ?? panels.at(-1));
  return own?.bounds ?? { x: 0, y: 0, width: 1, height };
}

/**
 * @param {Geometry} geometry
 * @param {Pick<Word, 'panel'>} word
 * @param {Place} place fractions
 * @returns {Place} in page widths
 */
export function pagePoint(geometry, word, [x, y]) {
  const frame = frameOf(geometry, word);
  return [frame.x + x * frame.width, frame.y + y * frame.height];
}

/**
 * A word with its middle at a place of the page: it stands on the panel there, the uppermost where several lie on one
 * another, and stays on its own in a gutter. The tail points where it is told.
 * @param {Geometry} geometry
 * @param {Word} word
 * @param {Place} to
 * @param {Place | null} tip
 * @returns {Partial<Word>}
 */
export function anchored(geometry, word, to, tip) {
  const at = /** @type {Place} */ ([Math.min(1, Math.max(0, to[0])), Math.min(geometry.height, Math.max(0, to[1]))]);
  const below = geometry.panels.findLastIndex(({ bounds }) => contains(bounds, at));
  const panel = below < 0 ? (word.panel ?? null) : below;
  const frame = frameOf(geometry, { panel });
  const part = (/** @type {Place} */ [x, y]) => ({ x: within((x - frame.x) / frame.width), y: within((y - frame.y) / frame.height) });
  return { panel, ...part(at), tail: tip && part(tip) };
}

/** @param {Bounds} bounds @param {Place} place */
function contains({ x, y, width, height }, [px, py]) {
  return px >= x && px <= x + width && py >= y && py <= y + height;
}

/** @param {number} part @returns {number} one that the core takes: of a narrow panel the page is many widths */
function within(part) {
  return Math.min(MOST.away, Math.max(-MOST.away, Math.round(part * 1e5) / 1e5));
}
