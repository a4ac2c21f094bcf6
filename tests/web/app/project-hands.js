// @ts-check
/** Project files that the app saves, with all kinds of content. */

import { readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { chunksOf, dataOf, textHead, textOf } from '../../../www/engine/png-chunks.ts';
import { readArchive } from '../../../www/engine/archive.ts';
import { savedAs } from './export-hands.js';
import { PNG, expect } from './support.js';

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

const STYLE = {
  id: 'mine',
  name: 'Mine',
  tags: ['ink'],
  background: [
    { block: 'posterize', levels: 4 },
    { block: 'to_gray', bypass: true },
  ],
  foreground: [{ block: 'to_gray' }, { block: 'xdog' }],
  ink: '#203050',
};
const LAYOUTS = new URL('../../../layouts/', import.meta.url);

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
  const png = await savedAs(page, 'png');
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

/** Adds text items, a custom style, a draft and a crop, which tests can damage. @param {any} document */
function enriched(document) {
  const { present } = document.history;
  present.name = 'Hostile';
  present.ownLayouts = [{ ...JSON.parse(readFileSync(new URL('cinema-3.json', LAYOUTS), 'utf8')), id: 'own' }];
  present.mine = [STYLE];
  present.favourites = [{ ...STYLE, id: 'loved' }];
  present.page.words = [
    { kind: 'caption', text: 'Meanwhile', panel: 0, auto: true },
    {
      kind: 'balloon',
      text: 'HO',
      shape: 'shout',
      panel: 0,
      x: 0.4,
      y: 0.3,
      width: 0.2,
      size: 0.03,
      tail: { x: 0.6, y: 0.6 },
      font: 'comic-neue',
      color: '#111111',
      fill: '#ffffff',
      auto: false,
    },
    { kind: 'effect', text: 'BAM', panel: null, x: 0.5, y: 0.5, angle: -8, arc: 0.2, auto: false },
  ];
  present.page.panels[0].crop = { x: 0.1, y: 0.2, width: 0.5, height: 0.4 };
  present.tray[0] = { ...present.tray[0], focus: { x: 0.5, y: 0.25 } };
  return document;
}
