/** Files that systems and programs store next to photos. They contain no photos. */

/** Hidden files such as `._photo.jpg` and `.DS_Store`, indexes of Windows and Picasa, folder icons of macOS. */
const SYSTEM = /^(?:\.|(?:thumbs\.db|ehthumbs\.db|desktop\.ini|picasa\.ini|icon\r)$)/i;
/** Edits of photos by iPhones and by programs for raw photos. */
const EDITS = /\.(?:aae|xmp)$/i;
/** Folders of macOS archives and of Synology NAS devices. */
const FOLDERS: readonly string[] = ['__MACOSX', '@eaDir'];

/** Whether a file is stored next to photos by a system or program. */
export function isSidecar(name: string, folders: readonly string[]): boolean {
  return SYSTEM.test(name) || EDITS.test(name) || folders.some((folder) => FOLDERS.includes(folder));
}
