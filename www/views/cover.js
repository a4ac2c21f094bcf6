// @ts-check
/**
 * The part in the middle of a photo that fills a thumbnail, so that nothing is squeezed.
 * @param {{ width: number, height: number } | null | undefined} photo
 * @param {number} [aspect] of the thumbnail, width over height
 * @returns {import('../engine/documents.js').Bounds} in parts of the photo
 */
export function covering(photo, aspect = 1) {
  const { width, height } = photo ?? { width: aspect, height: 1 };
  const part = width / height / aspect;
  const [w, h] = [Math.min(1, 1 / part), Math.min(1, part)];
  return { x: (1 - w) / 2, y: (1 - h) / 2, width: w, height: h };
}
