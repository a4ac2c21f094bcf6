// @ts-check
/** Unreadable files: each is reported with its name and the reason, and the other files are used. */

import { readFile } from 'node:fs/promises';
import { crc32 } from 'node:zlib';
import { tables } from '../database.js';
import {
  SIX,
  accessible,
  add,
  contents,
  dismissAlerts,
  expect,
  faultTest,
  idle,
  openBoard,
  openStart,
  photos,
  picture,
  press,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

const GIF = new URL('../../../oracles/data/animations/kept.gif', import.meta.url);

/** @param {string} name @param {Buffer} buffer */
const file = (name, buffer) => ({ name, mimeType: 'image/jpeg', buffer });

/** @param {number} count */
const unreadable = (count) =>
  Array.from({ length: count }, (_, i) => file(`bad-${i + 1}.jpg`, Buffer.from(`no photo ${i}`)));

/** Waits until a message has moved to its place. @param {import('../../../../www/testing.ts').Locator} toast */
const arrived = (toast) => toast.evaluate((one) => Promise.all(one.getAnimations().map(({ finished }) => finished)));

/** A PNG file whose header declares 60,000 x 60,000 pixels, without pixel data. */
function oversizedPng() {
  const chunk = (/** @type {string} */ type, /** @type {Buffer} */ data) => {
    const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc32(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(60_000, 0);
  header.writeUInt32BE(60_000, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const magic = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([magic, chunk('IHDR', header), chunk('IDAT', Buffer.alloc(9)), chunk('IEND', Buffer.alloc(0))]);
}

/** @param {Page} page */
const alert = (page) => page.getByRole('alert');

/** Waits until the database has no project that is listed. @param {Page} page */
async function expectNoProject(page) {
  const listed = async () => Object.values((await tables(page)).projects).filter(({ gone }) => gone === null);
  await expect.poll(listed).toEqual([]);
  await page.getByRole('button', { name: 'Projects', exact: true }).click();
  await expect(page.getByText('Your work is saved here automatically.')).toBeVisible();
  await page.keyboard.press('Escape');
}

/** Opens the list of the unreadable files. @param {Page} page */
async function showList(page) {
  await alert(page).getByRole('button', { name: 'Show the list' }).click();
  return page.getByRole('dialog').getByRole('listitem');
}

test('unreadable files are listed with the reason, and the other files become a comic page', async ({ page }) => {
  const [cat] = await photos('cat.jpg');
  const gif = (await readFile(GIF)).subarray(0, 30);
  const heic = Buffer.from('\0\0\0\x18ftypheic\0\0\0\0mif1heic'.padEnd(400, 'x'), 'latin1');
  /** The reason that the list shows for each file. @type {[string, Buffer, RegExp][]} */
  const files = [
    ['notes.txt', Buffer.from('Dear diary, this is no photo.'), /.{8,}/],
    ['half.jpg', cat.buffer.subarray(0, Math.floor(cat.buffer.length / 2)), /.{8,}/],
    ['empty.png', Buffer.alloc(0), /.{8,}/],
    ['huge.png', oversizedPng(), /.{8,}/],
    ['none.gif', Buffer.concat([gif, Buffer.from('rest of nothing')]), /.{8,}/],
    ['phone.heic', heic, /.*HEIC.*JPEG/],
  ];
  await openStart(page);
  await add(page, [...(await photos(...SIX)), ...files.map(([name, buffer]) => file(name, buffer))]);
  await idle(page);
  await expect(alert(page)).toContainText('6 files could not be read');
  const list = await showList(page);
  for (const [name, , reason] of files) {
    await expect(list.filter({ hasText: new RegExp(`^${name}${reason.source}`) })).toBeVisible();
    await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toHaveCount(0);
  }
  await page.keyboard.press('Escape');
  const { photos: shown } = await contents(page);
  expect(shown.every((name) => SIX.includes(String(name)))).toBe(true);
  await press(page, 'Shuffle');
});

test('if no file is readable, the start screen says so and accepts other files', async ({ page }) => {
  await openStart(page);
  await add(page, [file('notes.txt', Buffer.from('no photo')), file('more.txt', Buffer.from('none either'))]);
  await expect(alert(page)).toContainText('None of these files could be used');
  const choose = page.getByRole('button', { name: 'Choose photos or a video' });
  await expect(choose).toBeVisible();
  await expectNoProject(page);
  await dismissAlerts(page);

  // The message is below the buttons of the start screen.
  const dialog = page.waitForEvent('filechooser');
  await choose.click();
  await (await dialog).setFiles([file('notes.txt', Buffer.from('no photo'))]);
  const toast = alert(page).locator('.toast');
  await expect(toast).toContainText('notes.txt');
  await arrived(toast);
  const [button, near] = [await choose.boundingBox(), await toast.boundingBox()];
  expect(Math.abs(Number(near?.y) - Number(button?.y) - Number(button?.height))).toBeLessThan(30);
  expect(Number(near?.x)).toBeLessThan(Number(button?.x) + Number(button?.width));
  await expectNoProject(page);
  // A click elsewhere does not move the message.
  await page.mouse.click(2, 2);
  const after = await toast.boundingBox();
  expect(Math.hypot(Number(after?.x) - Number(near?.x), Number(after?.y) - Number(near?.y))).toBeLessThan(3);
  await dismissAlerts(page);

  // Subtitles of millions of tags, and subtitles that are larger than the limit.
  const tags = `00:00:01,000 --> 00:00:02,000\n${'<'.repeat(4_900_000)}`;
  await add(page, [
    { name: 'wall.srt', mimeType: 'text/plain', buffer: Buffer.from(tags) },
    { name: 'large.srt', mimeType: 'text/plain', buffer: Buffer.alloc(5_000_001, '1\n') },
  ]);
  await expect(alert(page)).toContainText('2 files could not be read.');
  const list = await showList(page);
  await expect(list.filter({ hasText: /^wall\.srt.*there is no page yet/ })).toBeVisible();
  await expect(list.filter({ hasText: /^large\.srt.*larger than 5 MB/ })).toBeVisible();
  await page.keyboard.press('Escape');

  await add(page, await photos('cat.jpg'));
  await idle(page);
  await expect(page.getByRole('group', { name: 'Panel 1 of 1' })).toBeVisible();
});

test('an unreadable file changes neither the page nor its history, and the alert can be dismissed', async ({
  page,
}) => {
  await openBoard(page);
  const before = await picture(page);
  await add(page, [file('broken.jpg', Buffer.from([0xff, 0xd8, 0xff, 0xe0, 0, 0]))]);
  await expect(alert(page)).toContainText('broken.jpg');
  await arrived(alert(page).locator('.toast'));
  // The message is among the photos, and covers none.
  const [toast, photo, tray] = await Promise.all(
    [alert(page).locator('.toast'), page.locator('.photo').first(), page.locator('.tray')].map((one) =>
      one.boundingBox(),
    ),
  );
  if (!toast || !photo || !tray) throw new Error('no message or no photos');
  expect(toast.x + toast.width).toBeLessThanOrEqual(tray.x + tray.width);
  expect(toast.y + toast.height).toBeLessThanOrEqual(photo.y);
  await idle(page);
  expect(await picture(page)).toBe(before);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(alert(page)).toHaveText('');
});

test('many unreadable files are one message, whose list works with keyboard and screen reader', async ({ page }) => {
  await openBoard(page);
  await add(page, [...unreadable(9), ...(await photos('pika.jpg'))]);
  await idle(page);
  await expect(alert(page)).toContainText('9 files could not be read.');
  await expect(alert(page).getByRole('button', { name: 'Dismiss' })).toHaveCount(1);
  await accessible(page);
  const open = alert(page).getByRole('button', { name: 'Show the list' });
  await open.focus();
  await page.keyboard.press('Enter');
  const list = page.getByRole('dialog', { name: '9 files could not be read.' });
  await expect(list.getByRole('listitem')).toHaveCount(9);
  for (let i = 1; i <= 9; i += 1)
    await expect(list.getByRole('listitem').nth(i - 1)).toHaveText(new RegExp(`^bad-${i}\\.jpg.{8,}`));
  await accessible(page);
  await page.keyboard.press('Escape');
  await expect(list).toBeHidden();
  await expect(open).toBeFocused();
  // After Dismiss, the next unreadable file is a new message.
  await alert(page).getByRole('button', { name: 'Dismiss' }).click();
  await expect(alert(page)).toHaveText('');
  await add(page, [file('other.jpg', Buffer.from('no photo'))]);
  await expect(alert(page)).toContainText(/^other\.jpg: .{8,}/);
});

test('without a used photo the page says so, and a check box brings a photo back', async ({ page }) => {
  await openBoard(page);
  for (const name of SIX) await page.getByRole('checkbox', { name: `Use ${name}` }).uncheck();
  await expect(page.getByText('No photo is in use.')).toBeVisible();
  await page.getByRole('checkbox', { name: 'Use bee.jpg' }).check();
  await idle(page);
  expect((await contents(page)).photos).toContain('bee.jpg');
});

faultTest('the alert that the work is not saved stays first and in view among many alerts', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 640 });
  await page.addInitScript(() => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('no room', 'QuotaExceededError');
    };
  });
  await openBoard(page, SIX.slice(0, 2));
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await press(page, 'Shuffle');
  const grave = alert(page).getByText('Your work is not saved');
  await expect(grave).toBeVisible();
  for (let i = 0; i < 40; i += 1) {
    await add(page, [
      { name: `${i}.srt`, mimeType: 'text/plain', buffer: Buffer.from('no time') },
      { name: `${i}.inkpanel`, mimeType: '', buffer: Buffer.from('no ZIP') },
    ]);
  }
  await add(page, unreadable(34));
  await idle(page);
  await expect(alert(page)).toContainText(/\d+ files could not be read/);
  await expect(grave).toBeInViewport();
  const [top, first] = await Promise.all([grave.boundingBox(), alert(page).locator('.toast').first().innerText()]);
  expect(first).toContain('Your work is not saved');
  // The button that saves the work is visible, and nothing covers it.
  await alert(page).getByRole('button', { name: 'Save to file' }).click({ trial: true });
  expect(top).not.toBeNull();
});
