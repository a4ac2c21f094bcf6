/**
 * Whether a file's type or name is of a video. It is a separate module, because the video worker needs it and must not
 * bundle the code that starts that worker.
 */

export function isVideo(file: Blob & { name?: string }): boolean {
  return (
    file.type.startsWith('video/') || /\.(mp4|m4v|mov|webm|mkv|avi|mpe?g|m2?ts|wmv|flv|ogv|3gp)$/i.test(file.name ?? '')
  );
}
