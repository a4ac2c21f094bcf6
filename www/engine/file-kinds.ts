/** Kinds of files by name and by first bytes, from the table that is shared with the core (`crates/engine/src/kinds.rs`). */

import { FILE_KINDS, SIGNATURES, SYSTEM_FOLDERS, SYSTEM_NAMES } from './file-table.ts';
import type { FileKind, Role } from './file-table.ts';

const BY_ENDING: ReadonlyMap<string, FileKind> = new Map(
  FILE_KINDS.flatMap((kind) => kind.endings.split(' ').map((ending) => [ending, kind] as const)),
);
/** Number of bytes at the start of a file that signatures need. */
const HEAD = Math.max(...SIGNATURES.map(([at, bytes]) => at + bytes.length));

/** @returns the kind of a file by the ending of its name */
export function kindByName(name: string): FileKind | undefined {
  return BY_ENDING.get(/\.([^.]+)$/.exec(name.toLowerCase())?.[1] ?? '');
}

/** @returns whether a file has one of these roles by its name */
export function hasRole(name: string, ...roles: readonly Role[]): boolean {
  const role = kindByName(name)?.role;
  return role !== undefined && roles.includes(role);
}

/** @returns the kind of a file by its first bytes; undefined for photos that have a decoder, and if it is unknown */
export async function kindByContent(file: Blob): Promise<FileKind | undefined> {
  const bytes = new Uint8Array(await file.slice(0, HEAD).arrayBuffer());
  const found = SIGNATURES.find(([at, wanted]) => wanted.every((byte, i) => bytes[at + i] === byte));
  return found && BY_ENDING.get(found[2]);
}

/**
 * Finds the kind of a file that is not a photo. The content counts more than the name: an archive may have a wrong name.
 * @returns undefined if it is unknown
 */
export async function otherKind(file: File): Promise<FileKind | undefined> {
  const kind = (await kindByContent(file).catch(() => undefined)) ?? kindByName(file.name);
  return kind?.role === 'photo' ? undefined : kind;
}

/** @returns the endings of names of these kinds, for file dialogs: `.jpg,.png` */
export function endingsOf(...roles: readonly Role[]): string {
  const kinds = FILE_KINDS.filter(({ role }) => roles.includes(role));
  return kinds.flatMap(({ endings }) => endings.split(' ').map((ending) => `.${ending}`)).join(',');
}

/**
 * @param name of a file
 * @param folders that it is in
 * @returns whether a system or program stores it next to photos
 */
export function isSidecar(name: string, folders: readonly string[] = []): boolean {
  return isSystem(name) || hasRole(name, 'sidecar') || isTakeout(name) || folders.some(isSystem);
}

function isSystem(name: string): boolean {
  return name.startsWith('.') || SYSTEM_FOLDERS.includes(name) || SYSTEM_NAMES.includes(name.toLowerCase());
}

/** The data of a photo by Google Takeout, such as `photo.jpg.json`. */
function isTakeout(name: string): boolean {
  const [, ...parts] = name.toLowerCase().split('.');
  return parts.pop() === 'json' && parts.some((ending) => hasRole(`.${ending}`, 'photo', 'video'));
}
