// @ts-check
/** Files that were made to fill the memory or to hold the tab: each ends with a sentence, and nothing is touched. */

import { readFile, writeFile } from 'node:fs/promises';
import { crc32 } from 'node:zlib';
import { chunkOf, textChunk, withChunks } from '../../../www/engine/png-chunks.ts';
import { packedNothing, zipOf } from '../../../www/engine/testing-archives.ts';
import { savedAs } from './export-dialog.js';
import { contents, expect, idle, openBoard, photos, picture, press, test } from './support.js';

/** @typedef {import('./support.js').Page} Page */

const MB = 2 ** 20;
/** Maximum memory of the tab with its workers. */
const MOST_MEMORY = 1024 * MB;

const NOTHING = packedNothing(64);
/** 64 MB of nothing in 64 kB. @param {string} name @param {number} [size] what it says that it unpacks to */
const bomb = (name, size = 64 * MB) => ({
  name,
  content: NOTHING,
  method: 8,
  length: NOTHING.length,
  size,
  crc: NOTHING_CRC,
});
const NOTHING_CRC = crc32(Buffer.alloc(64 * MB));

/** @param {number} count @param {(photo: any, i: number) => any} [change] */
const photosOf = (count, change = (photo) => photo) =>
  Array.from({ length: count }, (_, i) =>
    change(
      { id: `n${i}`, name: `n${i}.jpg`, path: `photos/${i}.jpg`, type: 'image/jpeg', measured: true, subjects: [] },
      i,
    ),
  );

/** @param {any[]} list of photos @param {any} [present] */
function documentOf(list, present = {}) {
  const tray = list.map(({ id }) => ({ id, use: true }));
  return Buffer.from(
    JSON.stringify({
      format: 'inkpanel',
      version: 1,
      history: { present: { tray, ...present }, shown: [] },
      photos: list,
      videos: [],
    }),
  );
}

/** A valid page with too many text items. @param {number} count */
const wordy = (count) => ({
  version: 1,
  seed: 1,
  layout: 'cinema-3',
  style: 'acid',
  order: ['n0'],
  panels: Array(3).fill({ photo: 'n0', crop: null }),
  merges: [],
  words: Array(count).fill({ kind: 'caption', text: 'Meanwhile' }),
});

/** @param {Buffer} json @param {readonly import('../../../www/engine/testing-archives.ts').Made[]} files */
const project = (json, files) => zipOf([{ name: 'project.json', content: json, packed: true }, ...files]);

/** The processes of the page, and the most that each has held. @param {import('../../../www/testing.ts').Browser} browser */
async function memoryOf(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const held = await Promise.all(
    processInfo
      .filter(({ type }) => ['renderer', 'browser'].includes(type))
      .map(async ({ type, id }) => {
        const status = await readFile(`/proc/${id}/status`, 'utf8').catch(() => '');
        return { type, most: 1024 * Number(/VmHWM:\s+(\d+)/.exec(status)?.[1] ?? 0) };
      }),
  );
  return held;
}

/**
 * Drops the file, and checks that nothing is lost.
 * @param {Page} page
 * @param {string} path of the file
 * @param {RegExp} reason
 */
async function trapped(page, path, reason) {
  const before = [await picture(page), await contents(page)];
  const name = path.slice(path.lastIndexOf('/') + 1);
  await page.getByLabel('Photos or video').setInputFiles(path);
  await expect(
    page.getByRole('alert').getByText(new RegExp(`${name} could not be opened: .*${reason.source}`)),
  ).toBeVisible();
  await idle(page);
  expect([await picture(page), await contents(page)]).toEqual(before);
  await expect(page.getByRole('progressbar')).toHaveCount(0);
  // If several files fail, there is one message.
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(page.getByRole('alert')).toHaveText('');
}

/** Nothing was lost by any of them, and nothing has grown. @param {Page} page */
async function unharmed(page) {
  const before = [await picture(page), await contents(page)];
  const held = await memoryOf(/** @type {any} */ (page.context().browser()));
  for (const { type, most } of held) expect(most, `bytes of the ${type}`).toBeLessThan(MOST_MEMORY);
  await expect(page.getByText('Saved', { exact: true })).toBeVisible();
  await page.reload();
  await idle(page);
  expect([await picture(page), await contents(page)]).toEqual(before);
  await press(page, 'Shuffle');
  return held;
}

test('project files that are traps are refused, and what is open stays', async ({ page }, info) => {
  await openBoard(page);
  const [cat] = await photos('cat.jpg');
  const list = photosOf(48);
  const files = list.map(({ path }) => path);
  const lie = Buffer.concat([Buffer.from([0xff, 0xd8, 0xff]), Buffer.alloc(112 * MB - 3)]);
  const packed = packedNothing(112, '\xff\xd8\xff');
  const gigabyte = packedNothing(1024);
  for (const [name, buffer, reason] of /** @type {[string, Buffer, RegExp][]} */ ([
    [
      'three-gigabytes.inkpanel',
      project(
        documentOf(list),
        files.map((path) => bomb(path)),
      ),
      /exceeds the limits of a project/,
    ],
    [
      'silent.inkpanel',
      project(
        documentOf(list),
        files.map((path) => bomb(path, 1000)),
      ),
      /damaged/,
    ],
    [
      'within-bounds.inkpanel',
      project(
        documentOf(photosOf(4)),
        files.slice(0, 4).map((path) => bomb(path)),
      ),
      /damaged/,
    ],
    [
      'no-jpeg.inkpanel',
      project(documentOf(photosOf(1)), [
        { name: files[0], content: packed, method: 8, length: packed.length, size: lie.length, crc: crc32(lie) },
      ]),
      /damaged/,
    ],
    [
      'document.inkpanel',
      zipOf([{ name: 'project.json', content: gigabyte, method: 8, length: gigabyte.length, size: 1024 * MB }]),
      /exceeds the limits of a project/,
    ],
    [
      'brackets.inkpanel',
      zipOf([{ name: 'project.json', content: Buffer.alloc(30 * MB, '['), packed: true }]),
      /exceeds the limits of a project/,
    ],
    [
      'one-photo.inkpanel',
      project(documentOf(photosOf(5_000, (photo) => ({ ...photo, path: files[0] }))), [
        { name: files[0], content: cat.buffer },
      ]),
      /damaged/,
    ],
    [
      'name.inkpanel',
      project(documentOf(photosOf(1), { name: 'x'.repeat(50 * MB) }), [{ name: files[0], content: cat.buffer }]),
      /exceeds the limits of a project/,
    ],
    [
      'words.inkpanel',
      project(documentOf(photosOf(1), { page: wordy(20_000) }), [{ name: files[0], content: cat.buffer }]),
      /exceeds the limits of a project/,
    ],
    [
      'entries.inkpanel',
      zipOf(Array.from({ length: 65_000 }, (_, i) => ({ name: `photos/${i}` }))),
      /exceeds the limits of a project/,
    ],
  ])) {
    await test.step(name, async () => {
      await writeFile(info.outputPath(name), buffer);
      await trapped(page, info.outputPath(name), reason);
    });
  }
  await unharmed(page);
});

test('a project that names thousands of photos that it lacks opens with those that it has', async ({ page }, info) => {
  await page.goto('./');
  const [cat] = await photos('cat.jpg');
  const path = info.outputPath('lacks.inkpanel');
  await writeFile(path, project(documentOf(photosOf(4_900)), [{ name: 'photos/0.jpg', content: cat.buffer }]));
  await page.getByLabel('Photos or video').setInputFiles(path);
  await expect(page.getByRole('checkbox', { name: 'Use n0.jpg' })).toBeVisible();
  await expect(page.getByRole('alert').getByText(/^4,899 files could not be read/)).toBeVisible();
  await idle(page);
  await expect(page.getByText('Saved', { exact: true })).toBeVisible();
  await page.reload();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: 'Use n0.jpg' })).toBeVisible();
});

test('page PNGs that are traps are refused, and what is open stays', async ({ page }, info) => {
  await openBoard(page);
  const { bytes } = await savedAs(page, 'png', { project: true });
  await page.keyboard.press('Escape');
  const png = new Blob([new Uint8Array(bytes)]);
  const json = documentOf(photosOf(2), { page: {} }).toString();
  /** @param {string} text @param {Buffer<ArrayBuffer>} [archive] */
  const made = async (text, archive) => {
    const after = archive ? [await chunkOf('ipPh', archive)] : [];
    const plain = new Blob([png.slice(0, 33), png.slice(bytes.indexOf('IDAT') - 4)]);
    return Buffer.from(
      await (await withChunks(plain, { before: [await textChunk('inkpanel', text)], after })).arrayBuffer(),
    );
  };
  const whole = await textIn(bytes);
  for (const [name, buffer, reason] of /** @type {[string, Buffer, RegExp][]} */ ([
    [
      'photos.png',
      await made(whole, zipOf(photosOf(48).map(({ path }) => bomb(path)))),
      /exceeds the limits of a project/,
    ],
    ['text.png', await made(' '.repeat(256 * MB)), /damaged/],
    ['brackets.png', await made('['.repeat(4 * MB)), /exceeds the limits of a project/],
    [
      'name.png',
      await made(json.replace('"page"', `"name":"${'x'.repeat(3 * MB)}","page"`)),
      /exceeds the limits of a project/,
    ],
  ])) {
    await test.step(name, async () => {
      await writeFile(info.outputPath(name), buffer);
      await trapped(page, info.outputPath(name), reason);
    });
  }
  await unharmed(page);
});

/** The text chunk of a page's PNG. @param {Buffer} png @returns {Promise<string>} */
async function textIn(png) {
  const { chunksOf, textHead, textOf } = await import('../../../www/engine/png-chunks.ts');
  const file = new Blob([new Uint8Array(png)]);
  const chunk = (await chunksOf(file))?.find(({ type }) => type === 'iTXt');
  const head = chunk && (await textHead(file.slice(chunk.at, chunk.at + chunk.length)));
  return /** @type {string} */ (head && (await textOf(head, 4 * MB)));
}
