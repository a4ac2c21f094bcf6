/** A picture file as the logo of a board: a PNG as a data URL, no larger than a board holds, on white. */

import { MOST } from '../document/limits.ts';
import { strings } from '../strings/strings.ts';
import { urlOf } from '../ui/data-picture.tsx';
import { UserError } from '../ui/user-error.ts';

/** Maximum size of a logo in pixels. It fills its space in the header of a sheet at about 500 DPI. */
const ROOM = { width: 600, height: 264 };
/** Largest factor between two attempts to reduce a file that is too large. */
const SMALLER = 0.9;

/**
 * @returns the data URL
 * @throws a sentence that names the file
 */
export async function logoOf(file: File): Promise<string> {
  const address = URL.createObjectURL(file);
  try {
    const picture = new Image();
    picture.src = address;
    await picture.decode();
    return await fitting(picture, file.type === 'image/svg+xml');
  } catch (cause) {
    throw new UserError(strings.boards.noLogo({ name: file.name }), { cause });
  } finally {
    URL.revokeObjectURL(address);
  }
}

/** @param lines it is as sharp at any size */
async function fitting(picture: HTMLImageElement, lines: boolean): Promise<string> {
  const { naturalWidth: width, naturalHeight: height } = picture;
  let scale = Math.min(ROOM.width / width, ROOM.height / height, lines ? Number.POSITIVE_INFINITY : 1);
  for (;;) {
    const url = await drawn(picture, Math.round(width * scale), Math.round(height * scale));
    if (url.length <= MOST.logo) return url;
    scale *= Math.min(SMALLER, Math.sqrt(MOST.logo / url.length));
  }
}

async function drawn(picture: HTMLImageElement, width: number, height: number): Promise<string> {
  const canvas = new OffscreenCanvas(Math.max(1, width), Math.max(1, height));
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingQuality = 'high';
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
  const png = await canvas.convertToBlob({ type: 'image/png' });
  return urlOf(new Uint8Array(await png.arrayBuffer()), 'image/png');
}
