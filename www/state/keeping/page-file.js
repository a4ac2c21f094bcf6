// @ts-check
/**
 * A PNG that carries its project: in an `iTXt` chunk what `page-json.js` tells, and, where it was asked for, the photos as
 * an archive in a chunk of their own behind the pixels. Every other program shows the picture and passes over both.
 */

import { chunkOf, chunksOf, dataOf, isPng, textChunk, textHead, textOf, withChunks } from '../../engine/png-chunks.js';
import { PNG, TEXT } from '../../engine/limits.js';
import { archiveOf, readArchive } from './archive.js';
import { readProjectJson } from './project-json.js';
import { damaged } from './versions.js';

/** @typedef {import('../../engine/png-chunks.js').Chunk} Chunk */
/** A page that was found to have a project. @typedef {{ file: File, text: Chunk, photos: Chunk | null }} PageFile */

const KEYWORD = 'inkpanel';
/** By the letters' cases: not needed for the picture, of one program, may be copied with it. */
const PHOTOS = 'ipPh';

/**
 * @param {Blob} png
 * @param {string} json
 * @param {readonly { name: string, blob: Blob }[]} photos none: it does without
 * @returns {Promise<Blob>}
 */
export async function withProject(png, json, photos) {
  const before = [await textChunk(KEYWORD, json)];
  const after = photos.length > 0 ? [await chunkOf(PHOTOS, await archiveOf(photos))] : [];
  return withChunks(png, { before, after });
}

/** @param {File} file @returns {Promise<PageFile | null>} null where it has no project, or is no PNG */
export async function pageFileOf(file) {
  if (!await isPng(file)) return null;
  const chunks = await chunksOf(file);
  for (const text of chunks?.filter(({ type }) => type === 'iTXt').slice(0, PNG.texts) ?? []) {
    const head = await textHead(file.slice(text.at, text.at + text.length));
    if (head?.keyword === KEYWORD) return { file, text, photos: chunks?.find(({ type }) => type === PHOTOS) ?? null };
  }
  return null;
}

/**
 * @param {PageFile} page
 * @param {Pick<import('../store.js').Planner, 'readProject'>} planner
 * @returns {Promise<{ project: import('./project-json.js').FileProject, archive: import('./file-opening.js').Archive }>}
 *   rejects with `damaged-project`, `newer-project` or `too-large-project`
 */
export async function readPageFile({ file, text, photos }, planner) {
  const data = text.length > TEXT.page ? null : await dataOf(file, text);
  const head = data && await textHead(data);
  const json = head && await textOf(head, TEXT.page);
  if (!json) throw damaged('the text of the page is damaged');
  const project = readProjectJson(json, planner);
  if (!project.history.present.page) throw damaged('page: is missing');
  return { project, archive: photos ? await photosIn(file.slice(photos.at, photos.at + photos.length)) : new Map() };
}

/** Each entry knows its own checksum. A part that is broken costs the photos, not the page; one that is a trap costs all. @param {Blob} part */
function photosIn(part) {
  return readArchive(part).catch((error) => {
    if (error.code === 'damaged-project') return new Map();
    throw error;
  });
}
