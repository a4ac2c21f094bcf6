/** The pixels of an image that the browser decoded. */

import { failure } from './protocol.ts';

export type Pixels = { width: number; height: number; data: Uint8Array<ArrayBuffer> };

/** Positions of the channels in pixel formats with one byte per channel. */
const ORDERS: Record<string, [red: number, green: number, blue: number]> = {
  RGBA: [0, 1, 2],
  RGBX: [0, 1, 2],
  BGRA: [2, 1, 0],
  BGRX: [2, 1, 0],
};

/**
 * @param frame which is closed
 * @returns RGBA in sRGB, not premultiplied
 */
export async function rgbaOf(frame: VideoFrame): Promise<Pixels> {
  try {
    return (await converts()) ? await copied(frame) : await rearranged(frame);
  } finally {
    frame.close();
  }
}

async function copied(frame: VideoFrame): Promise<Pixels> {
  const { width, height } = frame.visibleRect as DOMRectReadOnly;
  const layout: VideoFrameCopyToOptions = { format: 'RGBA', colorSpace: 'srgb' };
  const data = new Uint8Array(frame.allocationSize(layout));
  await frame.copyTo(data, layout);
  return { width, height, data };
}

let asked: Promise<boolean> | undefined;

/** Whether the browser converts to the requested format. WebKit returns its own format without an error. */
function converts(): Promise<boolean> {
  asked ??= probe().catch(() => true);
  return asked;
}

/** Tests whether a red pixel stays red, and whether a video pixel has four bytes. */
async function probe(): Promise<boolean> {
  const canvas = new OffscreenCanvas(1, 1);
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.fillStyle = '#f00';
  context.fillRect(0, 0, 1, 1);
  const still = new VideoFrame(await createImageBitmap(canvas), { timestamp: 0 });
  const film = new VideoFrame(new Uint8Array(6), { format: 'I420', codedWidth: 2, codedHeight: 2, timestamp: 0 });
  try {
    const { data } = await copied(still);
    return data.length === 4 && data[0] > data[2] && film.allocationSize({ format: 'RGBA' }) === 16;
  } finally {
    still.close();
    film.close();
  }
}

/** Reorders RGB formats manually, and draws other formats. */
async function rearranged(frame: VideoFrame): Promise<Pixels> {
  const { width, height } = frame.visibleRect as DOMRectReadOnly;
  const order = ORDERS[frame.format ?? ''];
  if (!order || frame.allocationSize() !== 4 * width * height) return drawn(frame, width, height);
  const data = new Uint8Array(4 * width * height);
  await frame.copyTo(data);
  const opaque = frame.format?.endsWith('X') ?? false;
  const [red, green, blue] = order;
  for (let at = 0; at < data.length; at += 4) {
    const pixel = [data[at + red], data[at + green], data[at + blue]];
    data.set(pixel, at);
    if (opaque) data[at + 3] = 255;
  }
  return { width, height, data };
}

function drawn(frame: VideoFrame, width: number, height: number): Pixels {
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw failure('video-decoder', 'This browser does not hand over the pixels.');
  context.drawImage(frame, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  return { width, height, data: new Uint8Array(data.buffer) };
}
