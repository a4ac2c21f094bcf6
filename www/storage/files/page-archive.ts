/**
 * ZIP and CBZ files. Archives from Inkpanel contain their project as a project file next to the pages. Comic readers
 * skip it. Images in other archives are imported as photos.
 */

import { ARCHIVE, TEXT } from '../../engine/limits.ts';
import { MOST } from '../../document/limits.ts';
import { damaged } from '../../engine/protocol.ts';
import { noteFolders } from '../../photos/folders.ts';
import { hasRole, isSidecar, kindByContent, kindByName } from '../../engine/file-kinds.ts';
import { archiveOf, readArchive } from '../../engine/archive.ts';
import { withPage } from './page-file.ts';
import { reasonOfKind } from '../../ui/reason-of-kind.ts';
import { UserError } from '../../ui/user-error.ts';
import type { FileKind } from '../../engine/file-table.ts';
import type { Watch } from '../../engine/inflate.ts';
import type { Archive } from './file-opening.ts';
import type { PageFile } from './page-file.ts';
import type { Work } from '../../engine/archive.ts';

/** Name of the project file in an archive. */
const PROJECT = 'project.inkpanel';
/** The text of a project file. */
const TEXT_NAME = 'project.json';

/**
 * Content of an archive: pages with their project, a project file with another file name, or images. `damaged` are the
 * names of damaged images, `beyond` is the number of images above the limit, and `others` is the number of all other files.
 */
export type Inside =
  | { page: PageFile }
  | { project: true }
  | {
      pictures: File[];
      damaged: string[];
      beyond: number;
      unsupported: { name: string; kind: FileKind }[];
      others: number;
    };

/** @returns whether name or type mark it as an archive */
export const isArchiveFile = ({ name, type }: File): boolean =>
  hasRole(name, 'archive') ||
  ['application/zip', 'application/x-zip-compressed', 'application/vnd.comicbook+zip'].includes(type);

/** @returns the project in an archive of pages */
export async function projectEntry(
  json: string,
  photos: readonly { name: string; blob: Blob }[],
  work: Work,
): Promise<{ name: string; blob: Blob }> {
  return { name: PROJECT, blob: await archiveOf([{ name: TEXT_NAME, blob: new Blob([json]) }, ...photos], work) };
}

/**
 * @param step receives the number of extracted images
 * @returns rejects with `damaged-project` if it is not an archive, `too-large-project` if its unpacked size exceeds the
 *   limit
 */
export async function readInside(
  file: File,
  { step, ...watch }: Watch & { step: (done: number, total: number) => void },
): Promise<Inside> {
  const kind = await kindByContent(file);
  if (kind?.role === 'unsupported') throw new UserError(reasonOfKind(kind));
  const archive = await readArchive(file);
  const project = archive.get(PROJECT);
  if (project) return { page: { file, read: (planner, watch) => readProject(project, planner, watch) } };
  if (archive.has(TEXT_NAME)) return { project: true };
  const files = [...archive.values()].filter(({ name }) => !/[\\/]$/.test(name));
  const wanted = files.filter(({ name }) => isPicture(name));
  const unsupported = files.flatMap(({ name }) => {
    const { own, folders } = placeOf(name);
    const kind = isSidecar(own, folders) ? undefined : kindByName(own);
    return kind?.role === 'unsupported' ? [{ name: own, kind }] : [];
  });
  const pictures: File[] = [];
  const spoilt: string[] = [];
  for (const { name, read } of wanted.slice(0, MOST.photos)) {
    step(pictures.length + spoilt.length, wanted.length);
    const { own, folders } = placeOf(name);
    const type = kindByName(own)?.type ?? '';
    const bytes = await read(watch).catch((error) => {
      if (error.code !== 'damaged-project') throw error;
      spoilt.push(own);
      return null;
    });
    if (!bytes) continue;
    const picture = new File([bytes], own, { type, lastModified: file.lastModified });
    pictures.push(noteFolders(picture, [file.name.replace(/\.[^.]*$/, ''), ...folders]));
  }
  const beyond = Math.max(0, wanted.length - MOST.photos);
  const others = files.length - wanted.length - unsupported.length;
  return { pictures, damaged: spoilt, beyond, unsupported, others };
}

async function readProject(
  found: NonNullable<ReturnType<Archive['get']>>,
  planner: Parameters<PageFile['read']>[0],
  watch: Watch = {},
) {
  // An uncompressed project is a slice of the file, at any size. A compressed one must be in memory.
  const archive = await readArchive(await found.read(found.packed ? { most: ARCHIVE.entry, ...watch } : watch));
  const text = await archive.get(TEXT_NAME)?.read({ most: TEXT.project, ...watch });
  if (!text) throw damaged(`${TEXT_NAME} is missing`);
  return { project: withPage(await text.text(), planner), archive };
}

/** Whether a path is of a photo or video, and not of a sidecar file. */
function isPicture(path: string): boolean {
  const { own, folders } = placeOf(path);
  return !isSidecar(own, folders) && hasRole(own, 'photo', 'video');
}

/** @returns the name of a file in an archive, and its folders. Some programs for Windows write backslashes */
function placeOf(path: string): { own: string; folders: string[] } {
  const folders = path.split(/[\\/]/);
  const own = folders.pop() as string;
  return { own, folders };
}
