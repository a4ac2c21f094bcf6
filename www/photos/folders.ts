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

/** @returns files in natural order, with the files of a folder at the position of its name */
export function inFolderOrder(files: readonly File[]): File[] {
  const { compare } = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });
  const placed = files.map((file) => ({ file, path: [...foldersOf(file), file.name] }));
  placed.sort((a, b) => {
    const at = a.path.findIndex((part, i) => part !== b.path[i]);
    return at < 0 ? a.path.length - b.path.length : compare(a.path[at], b.path[at] ?? '');
  });
  return placed.map(({ file }) => file);
}
