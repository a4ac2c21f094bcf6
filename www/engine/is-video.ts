/** Whether a file calls itself a film. By itself: the worker that reads films asks it too, and must not bundle what starts that worker. */

export function isVideo(file: Blob & { name?: string }): boolean {
  return (
    file.type.startsWith('video/') || /\.(mp4|m4v|mov|webm|mkv|avi|mpe?g|m2?ts|wmv|flv|ogv|3gp)$/i.test(file.name ?? '')
  );
}
