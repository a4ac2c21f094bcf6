// @ts-check
import { crc32 } from 'node:zlib';
import { SIX, add, contents, expect, idle, openBoard, photos, picture, press, test } from '../support.js';

/** @param {string} name @param {Buffer} buffer */
const file = (name, buffer) => ({ name, mimeType: 'image/jpeg', buffer });

/** A PNG that claims sides of sixty thousand pixels and holds none. */
function lyingPng() {
  const chunk = (/** @type {string} */ type, /** @type {Buffer} */ data) => {
    const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(60_000, 0);
  header.writeUInt32BE(60_000, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const magic = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([magic, chunk('IHDR', header), chunk('IDAT', Buffer.alloc(9)), chunk('IEND', Buffer.alloc(0))]);
}

/** @param {Buffer} data */
function crc(data) {
  if (crc32) return crc32(data);
  let rest = 0xffffffff;
  for (const byte of data) {
    rest ^= byte;
    for (let bit = 0; bit < 8; bit += 1) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  }
  return (rest ^ 0xffffffff) >>> 0;
}

test('bad files are named with the reason, and the rest go on', async ({ page }) => {
  const [cat] = await photos('cat.jpg');
  await page.goto('./');
  await add(page, [
    ...(await photos(...SIX)),
    file('notes.txt', Buffer.from('Dear diary, this is no photo.')),
    file('half.jpg', cat.buffer.subarray(0, Math.floor(cat.buffer.length / 2))),
    file('empty.png', Buffer.alloc(0)),
    file('huge.png', lyingPng()),
  ]);
  await idle(page);
  await expect(page.getByRole('alert')).toContainText('4 files could not be read');
  await page.getByRole('button', { name: 'Show the list' }).click();
  for (const name of ['notes.txt', 'half.jpg', 'empty.png', 'huge.png']) {
    await expect(
      page
        .getByRole('dialog')
        .getByRole('listitem')
        .filter({ hasText: new RegExp(`^${name}.{8,}`) }),
    ).toBeVisible();
    await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toHaveCount(0);
  }
  await page.keyboard.press('Escape');
  const { photos: shown } = await contents(page);
  expect(shown.every((name) => SIX.includes(String(name)))).toBe(true);
  await press(page, 'Shuffle');
});

test('files that are all bad leave a start that says so', async ({ page }) => {
  await page.goto('./');
  await add(page, [file('notes.txt', Buffer.from('no photo')), file('more.txt', Buffer.from('none either'))]);
  await expect(page.getByRole('alert')).toContainText('None of these files could be used');
  await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
  await add(page, await photos('cat.jpg'));
  await idle(page);
  await expect(page.getByRole('group', { name: 'Panel 1 of 1' })).toBeVisible();
});

test('a bad file on a page leaves the page and its history as they are', async ({ page }) => {
  await openBoard(page);
  const before = await picture(page);
  await add(page, [file('broken.jpg', Buffer.from([0xff, 0xd8, 0xff, 0xe0, 0, 0]))]);
  await expect(page.getByRole('alert')).toContainText('broken.jpg');
  await idle(page);
  expect(await picture(page)).toBe(before);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('no photo in use gives a page that says so, and one tick brings it back', async ({ page }) => {
  await openBoard(page, ['cat.jpg', 'bee.jpg']);
  for (const name of ['cat.jpg', 'bee.jpg']) await page.getByRole('checkbox', { name: `Use ${name}` }).uncheck();
  await expect(page.getByText('No photo is in use.')).toBeVisible();
  await page.getByRole('checkbox', { name: 'Use bee.jpg' }).check();
  await idle(page);
  expect((await contents(page)).photos).toContain('bee.jpg');
});

test('an alert can be dismissed', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  await add(page, [file('notes.txt', Buffer.from('no photo'))]);
  await expect(page.getByRole('alert')).toContainText('notes.txt');
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(page.getByRole('alert')).toHaveText('');
});
