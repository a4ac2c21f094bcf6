// @ts-check
/** Folders that are dropped: with entries that cannot be read, and with files that systems and programs store next to photos. */

import { drop, expect, idle, openBoard, photos, test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** @param {Page} page */
const inTray = (page) =>
  page
    .getByRole('checkbox', { name: /^Use / })
    .evaluateAll((boxes) => boxes.map((box) => box.getAttribute('aria-label')?.replace('Use ', '')));

/**
 * Drops a folder `trip` with some files.
 * @param {Page} page
 * @param {{ name: string, mimeType: string, buffer: Buffer }[]} files
 * @param {string[]} [gone] names of entries that cannot be read
 */
async function dropFolder(page, files, gone = []) {
  const plain = files.map(({ name, mimeType, buffer }) => ({ name, mimeType, base64: buffer.toString('base64') }));
  await page.evaluate(
    ({ plain, gone }) => {
      const entry = (/** @type {string} */ name, /** @type {object} */ more) => ({
        isFile: true,
        isDirectory: false,
        name,
        fullPath: `/trip/${name}`,
        ...more,
      });
      const refused = () => new DOMException('A requested file or directory could not be found.', 'NotFoundError');
      const entries = [
        ...gone.map((name) =>
          entry(name, { file: (/** @type {any} */ _, /** @type {any} */ fail) => fail(refused()) }),
        ),
        ...plain.map(({ name, mimeType, base64 }) => {
          const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
          const file = new File([bytes], name, { type: mimeType });
          return entry(name, { file: (/** @type {any} */ take) => take(file) });
        }),
      ];
      const reads = [entries, []];
      const folder = {
        isFile: false,
        isDirectory: true,
        name: 'trip',
        fullPath: '/trip',
        createReader: () => ({ readEntries: (/** @type {any} */ take) => take(reads.shift()) }),
      };
      const transfer = new DataTransfer();
      transfer.items.add(new File([], 'trip'));
      // The browser makes entries of real files only.
      Object.defineProperty(DataTransferItem.prototype, 'webkitGetAsEntry', { value: () => folder });
      for (const type of ['dragenter', 'dragover', 'drop'])
        document.body.dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    },
    { plain, gone },
  );
}

const text = (/** @type {string} */ name, /** @type {string} */ content) => ({
  name,
  mimeType: '',
  buffer: Buffer.from(content),
});

test('an entry that cannot be read is named, and the other photos of the folder come', async ({ page }) => {
  await page.goto('./');
  await dropFolder(page, await photos('bee.jpg', 'cat.jpg'), ['gone.jpg']);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  expect(await inTray(page)).toEqual(['bee.jpg', 'cat.jpg']);
  await expect(page.getByRole('alert')).toContainText('trip/gone.jpg: the browser cannot read it.');
});

test('files of systems, sidecar files and a readme of a folder are no photos and no words', async ({ page }) => {
  await page.goto('./');
  await dropFolder(page, [
    text('.DS_Store', 'Bud1'),
    text('._bee.jpg', 'Mac OS X'),
    text('Thumbs.db', 'x'),
    text('desktop.ini', '[.ShellClassInfo]'),
    text('bee.AAE', '<plist/>'),
    text('bee.xmp', '<x:xmpmeta/>'),
    text('bee.jpg.json', '{"title":"bee.jpg","photoTakenTime":{"timestamp":"1"}}'),
    text('notes.txt', 'Nothing that anybody says.'),
    text('readme.txt', 'Album: Summer in Lisbon\nCamera: Nikon D70\n'),
    ...(await photos('bee.jpg', 'cat.jpg')),
  ]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  expect(await inTray(page)).toEqual(['bee.jpg', 'cat.jpg']);
  await expect(page.getByRole('alert')).toHaveText('');
  const offer = page.getByRole('status').filter({ hasText: 'readme.txt may be a script.' });
  await expect(offer).toBeVisible();
  await expect(page.locator('.word')).toHaveCount(0);
});

test('JSON of another program that comes alone is said to be neither a layout nor a style', async ({ page }) => {
  await openBoard(page, ['bee.jpg']);
  await drop(page, [text('bee.jpg.json', '{"title":"bee.jpg"}')]);
  await expect(page.getByRole('alert')).toContainText('bee.jpg.json: it is not an Inkpanel layout or style.');
});

test('a link that is dropped does not make the browser leave the app, and can be dropped on a field', async ({
  page,
}) => {
  await openBoard(page, ['bee.jpg']);
  /** Whether the app prevents the default action of the browser. */
  const prevented = (/** @type {import('../../../../www/testing.ts').Locator} */ target) =>
    target.evaluate((element) =>
      ['dragover', 'drop'].map((type) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.setData('text/uri-list', 'https://example.org/');
        return !element.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      }),
    );
  expect(await prevented(page.locator('body'))).toEqual([true, true]);
  expect(await prevented(page.getByRole('region', { name: 'Comic page' }))).toEqual([true, true]);
  expect(await prevented(page.getByLabel('Project name'))).toEqual([false, false]);
});
