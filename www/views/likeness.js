// @ts-check
/** How a page differs from the one before it, which says whether old pictures may stand in for new ones. */

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').Geometry} Geometry */

/**
 * @param {PageDocument} a
 * @param {PageDocument} b
 * @returns {boolean} whether the panels of both are the same ones, so that their pictures can follow each other
 */
export function sameShape(a, b) {
  return JSON.stringify([a.layout, a.merges]) === JSON.stringify([b.layout, b.merges]);
}

/**
 * @param {import('./painter.js').Sheet} old
 * @param {Geometry} geometry
 * @returns {boolean} whether there are as many panels as before
 */
export function onlyMoved({ slots }, { panels }) {
  return slots.length === panels.length;
}

/**
 * @param {PageDocument} a
 * @param {PageDocument} b
 * @returns {boolean} whether only lengths and colours differ, which must follow the hand at once
 */
export function sameLook(a, b) {
  const photos = (/** @type {PageDocument} */ { panels }) => panels.map(({ photo }) => photo);
  return JSON.stringify([a.style, photos(a)]) === JSON.stringify([b.style, photos(b)]);
}
