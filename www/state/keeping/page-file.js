// @ts-check
/**
 * A PNG that carries its project: in an `iTXt` chunk what `page-json.js` tells, and, where it was asked for, the photos as
 * an archive in a chunk of their own behind the pixels. Every other program shows the picture and passes over both.
 */

import { chunkOf, chunksOf, dataOf, isPng, textChunk, textHead, textOf, withChunks } from '../../engine/png-chunks.js';
import { archiveOf, readArchive } from './archive.js';
import { parsedProject } from './project-json.js';
import { damaged } from './versions.js';

/** @typedef {import('../../engine/png-chunks.js').Chunk} Chunk */
/** A page that was found to have a project. @typedef {{ file: File, text: Chunk, photos: Chunk | null }} PageFile */

const KEYWORD = 'inkpanel';
/** By the letters' cases: not needed for the picture, of one program, may be copied with it. */
const PHOTOS = 'ipPh';
/** Bytes of the text, unpacked and packed. A page of a hundred panels takes a hundredth. */
const LONGEST = 4 * 2 ** 20;
/** Texts of others that are looked at before it is taken for a picture like others. */
const MOST_TEXTS = 64;

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
  for (const text of chunks?.filter(({ type }) => type === 'iTXt').slice(0, MOST_TEXTS) ?? []) {
    const head = await textHead(file.slice(text.at, text.at + text.length));
    if (head?.keyword === KEYWORD) return { file, text, photos: chunks?.find(({ type }) => type === PHOTOS) ?? null };
  }
  return null;
}

/**
 * @param {PageFile} page
 * @returns {Promise<{ project: import('./project-json.js').FileProject, archive: import('./file-opening.js').Archive }>}
 *   rejects with `damaged-project` or `newer-project`
 */
export async function readPageFile({ file, text, photos }) {
  const data = text.length > LONGEST ? null : await dataOf(file, text);
  const head = data && await textHead(data);
  const json = head && await textOf(head, LONGEST);
  if (!json) throw damaged('the text of the page is damaged');
  const project = parsedProject(json);
  if (!project.history.present.page) throw damaged('page: is missing');
  // Each entry knows its own checksum. A part that is broken costs the photos, not the page.
  const archive = photos ? await readArchive(file.slice(photos.at, photos.at + photos.length)).catch(() => new Map()) : new Map();
  return { project, archive };
}
