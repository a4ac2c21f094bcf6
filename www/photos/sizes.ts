/** Sizes of photos from their headers: the browser reads them before it decodes a photo. */

import { after } from '../engine/scheduler.ts';

export type Size = { width: number; height: number };

/** Maximum time in ms, because the sketch of the first page waits for the sizes. */
const WAIT = 100;
/** Maximum number of files, which is enough for a first page. */
const MOST = 40;

/**
 * @param read reads the size of one file
 * @returns the sizes that are known in time
 */
export async function sizesOf(files: readonly File[], read = sizeOf): Promise<ReadonlyMap<File, Size>> {
  const sizes: Map<File, Size> = new Map();
  const all = files.slice(0, MOST).map(async (file) => {
    const size = await read(file).catch(() => null);
    if (size && size.width > 0 && size.height > 0) sizes.set(file, size);
  });
  let stop = () => {};
  const end = new Promise<void>((resolve) => {
    stop = after(WAIT, resolve);
  });
  await Promise.race([Promise.all(all), end]);
  stop();
  return new Map(sizes);
}

/** The upright size of a photo, or null if the browser cannot read its format. */
async function sizeOf(file: File): Promise<Size | null> {
  if (typeof Image === 'undefined') return null;
  const url = URL.createObjectURL(file);
  const image = new Image();
  return new Promise<Size | null>((resolve) => {
    image.onload = () => resolve({ width: image.naturalWidth, height: image.naturalHeight });
    image.onerror = () => resolve(null);
    image.src = url;
  }).finally(() => URL.revokeObjectURL(url));
}
