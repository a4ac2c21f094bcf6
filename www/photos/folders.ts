/** In which folders files came: the browser tells it apart from the files, and tells it once. */

const known: WeakMap<File, readonly string[]> = new WeakMap();

/** @param folders from the outermost */
export function noteFolders(file: File, folders: readonly string[]): File {
  known.set(file, folders);
  return file;
}

/** @returns from the outermost; none where it came alone */
export function foldersOf(file: File): readonly string[] {
  // Of a folder that was chosen in a dialog the file itself tells.
  return known.get(file) ?? (file.webkitRelativePath ?? '').split('/').slice(0, -1);
}
