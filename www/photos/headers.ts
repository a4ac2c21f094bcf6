/** Headers of the photos of an import. The layout of the first page suits their sizes. */

import { photoHeader } from '../engine/photo-header.ts';
import { after } from '../engine/scheduler.ts';
import type { PhotoHeader, Size } from '../engine/photo-header.ts';

/** Headers by file, while they are read. */
export type Headers = ReadonlyMap<File, Promise<PhotoHeader | null>>;

/** Maximum time in ms, because the sketch of the first page waits for the sizes. */
const WAIT = 100;
/** Maximum number of files, which is enough for a first page. */
const MOST = 40;

/** Begins to read the headers of the first files. */
export function headersOf(
  files: readonly File[],
  read: (file: File) => Promise<PhotoHeader | null> = photoHeader,
): Headers {
  return new Map(files.slice(0, MOST).map((file) => [file, read(file)]));
}

/** @returns the sizes that are known in time */
export async function sizesIn(headers: Headers): Promise<ReadonlyMap<File, Size>> {
  const sizes: Map<File, Size> = new Map();
  const all = [...headers].map(async ([file, reading]) => {
    const header = await reading;
    if (header) sizes.set(file, header.size);
  });
  let stop = () => {};
  const end = new Promise<void>((resolve) => {
    stop = after(WAIT, resolve);
  });
  await Promise.race([Promise.all(all), end]);
  stop();
  return new Map(sizes);
}
