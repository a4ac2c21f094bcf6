/** The pixels of a picture that the browser decoded. */

/**
 * @param frame which is closed
 * @returns RGBA in sRGB, not premultiplied
 */
export async function rgbaOf(
  frame: VideoFrame,
): Promise<{ width: number; height: number; data: Uint8Array<ArrayBuffer> }> {
  try {
    const { width, height } = frame.visibleRect as DOMRectReadOnly;
    const layout: VideoFrameCopyToOptions = { format: 'RGBA', colorSpace: 'srgb' };
    const data = new Uint8Array(frame.allocationSize(layout));
    await frame.copyTo(data, layout);
    return { width, height, data };
  } finally {
    frame.close();
  }
}
