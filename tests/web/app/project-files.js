// @ts-check
/** Project files that the app saves, with all kinds of content. */

import { readFile } from 'node:fs/promises';
import { chunksOf, dataOf, textHead, textOf } from '../../../www/engine/png-chunks.ts';
import { readArchive } from '../../../www/engine/archive.ts';
import { savedAs } from './export-dialog.js';
import { enriched } from './malformed-files.js';
import { PNG, expect, idle } from './support.js';

/** @typedef {import('./support.js').Page} Page */
/** A document and the files of its photos. @typedef {{ document: any, photos: { name: string, blob: Blob }[] }} Parts */

/** Three small photos. */
export const SMALL = ['one', 'two', 'three'].map((name, i) => {
  const png = new PNG({ width: 96, height: 64 });
  for (let at = 0; at < png.data.length; at += 4)
    png.data.set([(at * (i + 3)) % 251, (at >> (4 + i)) % 256, (at >> 9) % 256, 255], at);
  return { name: `${name}.png`, mimeType: 'image/png', buffer: PNG.sync.write(png) };
});

/** Waits until the app shows that all work is saved. @param {Page} page */
export const expectSaved = (page) => expect(page.locator('.save-state')).toHaveText('Saved', { timeout: 120_000 });
export { expectSaved as saved };

/** Reloads the app when the project is saved: the app asks before files are lost, and the browser of a test says yes. @param {Page} page */
export async function reloadSaved(page) {
  await expectSaved(page);
  await page.reload();
  await idle(page);
}

/** Saves the open project as a project file and as a PNG file, and adds content to both. @param {Page} page @returns {Promise<{ project: Parts, page: Parts }>} */
export async function goodFiles(page) {
  await page.getByRole('button', { name: 'Projects' }).click();
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save project' }).click();
  const archive = await readArchive(new Blob([new Uint8Array(await readFile(await (await waiting).path()))]));
  await page.getByRole('button', { name: 'Back to the page' }).click();
  const photos = await Promise.all(
    [...archive.values()]
      .filter(({ name }) => name !== 'project.json')
      .map(async ({ name, read }) => ({ name, blob: await read() })),
  );
  const project = JSON.parse(await (await /** @type {any} */ (archive.get('project.json')).read()).text());
  const png = await savedAs(page, 'png', { project: true });
  const file = new File([new Uint8Array(png.bytes)], 'page.png');
  const text = /** @type {any} */ ((await chunksOf(file))?.find(({ type }) => type === 'iTXt'));
  const head = /** @type {any} */ (await textHead(/** @type {any} */ (await dataOf(file, text))));
  const drawn = JSON.parse(String(await textOf(head, 1 << 22)));
  const packed = drawn.photos.map((/** @type {any} */ { path }, /** @type {number} */ i) => ({
    name: path,
    blob: photos[i % photos.length].blob,
  }));
  return { project: { document: enriched(project), photos }, page: { document: enriched(drawn), photos: packed } };
}
