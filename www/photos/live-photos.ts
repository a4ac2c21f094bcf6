/**
 * Live Photos of phones: a photo, and a short video with its name in its folder. The photo is added, and the video only if the
 * user wants it.
 */

import { hasRole } from '../engine/file-kinds.ts';
import { foldersOf } from './folders.ts';

/** Maximum number of bytes of such a video. It is about three seconds long. */
const MOST_BYTES = 32 * 2 ** 20;

/** @returns the videos of Live Photos among files, and all other files */
export function splitLivePhotos(files: readonly File[]): { videos: File[]; others: File[] } {
  const stem = (file: File) => [...foldersOf(file), file.name.replace(/\.[^.]*$/, '').toLowerCase()].join('/');
  const photos = new Set(files.filter(({ name }) => hasRole(name, 'photo')).map(stem));
  const isLive = (file: File) => /\.(?:mov|mp4)$/i.test(file.name) && file.size <= MOST_BYTES && photos.has(stem(file));
  return { videos: files.filter(isLive), others: files.filter((file) => !isLive(file)) };
}
