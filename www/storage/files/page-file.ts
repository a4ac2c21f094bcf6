/**
 * A PNG that carries its project: in an `iTXt` chunk what `page-json.ts` tells, and, where it was asked for, the photos as
 * an archive in a chunk of their own behind the pixels. Every other program shows the picture and passes over both.
 */

import { chunkOf, chunksOf, dataOf, isPng, textChunk, textHead, textOf, withChunks } from '../../engine/png-chunks.ts';
import { PNG, TEXT } from '../../engine/limits.ts';
import { archiveOf, readArchive } from './archive.ts';
import { readProjectJson } from './project-json.ts';
import { damaged } from '../../document/versions.ts';
import type { Planner } from '../../document/store.ts';
import type { Chunk } from '../../engine/png-chunks.ts';
import type { Archive } from './file-opening.ts';
import type { FileProject } from './project-json.ts';

/** A page that was found to have a project. */
export type PageFile = { file: File; text: Chunk; photos: Chunk | null };

const KEYWORD = 'inkpanel';
/** By the letters' cases: not needed for the picture, of one program, may be copied with it. */
const PHOTOS = 'ipPh';

/** @param photos none: it does without */
export async function withProject(
  png: Blob,
  json: string,
  photos: readonly { name: string; blob: Blob }[],
): Promise<Blob> {
  const before = [await textChunk(KEYWORD, json)];
  const after = photos.length > 0 ? [await chunkOf(PHOTOS, await archiveOf(photos))] : [];
  return withChunks(png, { before, after });
}

/** @returns null where it has no project, or is no PNG */
export async function pageFileOf(file: File): Promise<PageFile | null> {
  if (!(await isPng(file))) return null;
  const chunks = await chunksOf(file);
  for (const text of chunks?.filter(({ type }) => type === 'iTXt').slice(0, PNG.texts) ?? []) {
    const head = await textHead(file.slice(text.at, text.at + text.length));
    if (head?.keyword === KEYWORD) return { file, text, photos: chunks?.find(({ type }) => type === PHOTOS) ?? null };
  }
  return null;
}

/** @returns rejects with `damaged-project`, `newer-project` or `too-large-project` */
export async function readPageFile(
  { file, text, photos }: PageFile,
  planner: Pick<Planner, 'readProject'>,
): Promise<{ project: FileProject; archive: Archive }> {
  const data = text.length > TEXT.page ? null : await dataOf(file, text);
  const head = data && (await textHead(data));
  const json = head && (await textOf(head, TEXT.page));
  if (!json) throw damaged('the text of the page is damaged');
  const project = readProjectJson(json, planner);
  if (!project.history.present.page) throw damaged('page: is missing');
  return { project, archive: photos ? await photosIn(file.slice(photos.at, photos.at + photos.length)) : new Map() };
}

/** Each entry knows its own checksum. A part that is broken costs the photos, not the page; one that is a trap costs all. */
function photosIn(part: Blob) {
  return readArchive(part).catch((error) => {
    if (error.code === 'damaged-project') return new Map();
    throw error;
  });
}
