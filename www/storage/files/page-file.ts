/**
 * A PNG with its project: the text of `page-json.ts` in an `iTXt` chunk and, if requested, the photos as an archive in
 * another chunk after the pixels. Other programs show the image and ignore both.
 */

import { chunkOf, chunksOf, dataOf, isPng, textChunk, textHead, textOf, withChunks } from '../../engine/png-chunks.ts';
import { PNG, TEXT } from '../../engine/limits.ts';
import { archiveOf, readArchive } from '../../engine/archive.ts';
import { readProjectJson } from './project-json.ts';
import { damaged } from '../../engine/protocol.ts';
import { strings } from '../../strings/strings.ts';
import { UserError } from '../../ui/user-error.ts';
import type { Planner } from '../../document/store.ts';
import type { Watch } from '../../engine/inflate.ts';
import type { Work } from '../../engine/archive.ts';
import type { Chunk } from '../../engine/png-chunks.ts';
import type { Archive } from './file-opening.ts';
import type { FileProject } from './project-json.ts';

/**
 * A file that was found to have a project. `read` returns it with its photos, and rejects with `damaged-project`,
 * `newer-project` or `too-large-project`.
 */
export type PageFile = {
  file: File;
  read: (planner: Pick<Planner, 'readProject'>, watch?: Watch) => Promise<{ project: FileProject; archive: Archive }>;
};

const KEYWORD = 'inkpanel';
/** The case of the letters means: ancillary, private, safe to copy. */
const PHOTOS = 'ipPh';

/** @param photos null: without photos */
export async function withProject(
  png: Blob,
  json: string,
  photos: readonly { name: string; blob: Blob }[],
  work: Work = {},
): Promise<Blob> {
  const before = [await textChunk(KEYWORD, json)];
  const archive = photos.length > 0 ? await archiveOf(photos, work) : null;
  // The format has no longer chunks.
  if (archive && archive.size > PNG.longest) throw new UserError(strings.photosTooLarge);
  const after = archive ? [await chunkOf(PHOTOS, archive)] : [];
  return withChunks(png, { before, after });
}

/** @returns null if it has no project or is not a PNG */
export async function pageFileOf(file: File): Promise<PageFile | null> {
  if (!(await isPng(file))) return null;
  const chunks = await chunksOf(file);
  for (const text of chunks?.filter(({ type }) => type === 'iTXt').slice(0, PNG.texts) ?? []) {
    const head = await textHead(file.slice(text.at, text.at + text.length));
    if (head?.keyword !== KEYWORD) continue;
    const photos = chunks?.find(({ type }) => type === PHOTOS) ?? null;
    return { file, read: (planner) => readChunks(file, text, photos, planner) };
  }
  return null;
}

async function readChunks(file: File, text: Chunk, photos: Chunk | null, planner: Pick<Planner, 'readProject'>) {
  const data = text.length > TEXT.page ? null : await dataOf(file, text);
  const head = data && (await textHead(data));
  const json = head && (await textOf(head, TEXT.page));
  if (!json) throw damaged('the text of the page is damaged');
  const project = withPage(json, planner);
  return { project, archive: photos ? await photosIn(file.slice(photos.at, photos.at + photos.length)) : new Map() };
}

/** @returns throws if it has no page */
export function withPage(json: string, planner: Pick<Planner, 'readProject'>): FileProject {
  const project = readProjectJson(json, planner);
  if (!project.history.present.page) throw damaged('page: is missing');
  return project;
}

/**
 * Each entry contains its checksum. A damaged part loses only the photos. A malicious part rejects the whole file.
 */
function photosIn(part: Blob) {
  return readArchive(part).catch((error) => {
    if (error.code === 'damaged-project') return new Map();
    throw error;
  });
}
