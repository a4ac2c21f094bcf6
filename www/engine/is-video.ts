import { hasRole } from './file-kinds.ts';

/**
 * Whether a file's type or name is of a video. It is a separate module, because the video worker needs it and must not
 * bundle the code that starts that worker.
 */
export function isVideo(file: Blob & { name?: string }): boolean {
  return file.type.startsWith('video/') || hasRole(file.name ?? '', 'video');
}
