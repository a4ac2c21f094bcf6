/** Folders of added files. The browser reports them separately and only once. */

const known: WeakMap<File, readonly string[]> = new WeakMap();

/** @param folders from the outermost */
export function noteFolders(file: File, folders: readonly string[]): File {
  known.set(file, folders);
  return file;
}

/** @returns from the outermost; empty without a folder */
export function foldersOf(file: File): readonly string[] {
  // Files of a folder that was chosen in a dialog have a relative path.
  return known.get(file) ?? (file.webkitRelativePath ?? '').split('/').slice(0, -1);
}
