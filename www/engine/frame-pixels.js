// @ts-check
/** The pixels of a picture that the browser decoded. */

/**
 * @param {VideoFrame} frame which is closed
 * @returns {Promise<{ width: number, height: number, data: Uint8Array<ArrayBuffer> }>} RGBA in sRGB, not premultiplied
 */
export async function rgbaOf(frame) {
  try {
    const { width, height } = /** @type {DOMRectReadOnly} */ (frame.visibleRect);
    const layout = /** @type {any} */ ({ format: 'RGBA', colorSpace: 'srgb' });
    const data = new Uint8Array(frame.allocationSize(layout));
    await frame.copyTo(data, layout);
    return { width, height, data };
  } finally {
    frame.close();
  }
}
