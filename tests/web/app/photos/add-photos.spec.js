// @ts-check
/** The start screen, and the ways to add photos: file dialog, sample album, drop, paste. */

import {
  SIX,
  add,
  colours,
  contents,
  drop,
  expect,
  idle,
  openBoard,
  openStart,
  photos,
  picture,
  pixelsOf,
  press,
  sharedBoardTest as test,
} from '../support.js';

test('the start screen explains what to do, opens the file dialog, and opens the sample album', async ({ page }) => {
  await openStart(page);
  await expect(page).toHaveTitle(/Inkpanel/);
  await expect(page.getByRole('heading', { level: 1 })).toContainText('Drop your photos');
  const choose = page.getByRole('button', { name: 'Choose photos or a video' });
  await expect(choose).toBeVisible();
  await expect(page.getByText('Nothing leaves this device.')).toBeVisible();
  const chooser = page.waitForEvent('filechooser');
  await choose.click();
  expect((await chooser).isMultiple()).toBe(true);

  await page.getByRole('button', { name: 'Try the sample album' }).click();
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  const tray = page.getByRole('region', { name: 'Photos' }).getByRole('checkbox');
  await expect(tray).not.toHaveCount(0);
  expect(await tray.count()).toBeGreaterThanOrEqual(10);
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
});

test('photos dropped on the start screen become a comic page', async ({ page }) => {
  await openStart(page);
  await drop(page, await photos(...SIX));
  await expect(page.getByRole('group', { name: /^Panel 1 of / })).toBeVisible();
  await idle(page);
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}`, exact: true })).toBeAttached();
  const { photos: shown } = await contents(page);
  expect(shown.length).toBeGreaterThan(0);
  expect(shown.every((name) => SIX.includes(String(name)))).toBe(true);
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
});

test('a pasted photo is added, and a copy of a photo is set aside with the reason', async ({ page }) => {
  await openStart(page);
  const [cat, bee] = await photos('cat.jpg', 'bee.jpg');
  await page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const data = new DataTransfer();
    data.items.add(new File([bytes], 'pasted.jpg', { type: 'image/jpeg' }));
    window.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data }));
  }, cat.buffer.toString('base64'));
  await expect(page.getByRole('checkbox', { name: 'Use pasted.jpg' })).toBeAttached();
  await idle(page);
  expect((await contents(page)).photos[0]).toBe('pasted.jpg');

  await add(page, [{ ...cat, name: 'cat.jpg' }, bee]);
  await idle(page);
  const twins = [
    page.getByRole('checkbox', { name: 'Use pasted.jpg' }),
    page.getByRole('checkbox', { name: 'Use cat.jpg' }),
  ];
  const used = await Promise.all(twins.map((twin) => twin.isChecked()));
  expect(used.filter(Boolean).length).toBe(1);
  // The reason names the photo that is used.
  await expect(twins[used.indexOf(false)]).toHaveAccessibleDescription(used[0] ? /pasted/ : /cat/);
});

test('photos dropped on a comic page join it, and one undo step removes them', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  const before = await picture(page);
  await drop(page, await photos('pika.jpg', 'palace.jpg'));
  await expect(page.getByRole('checkbox', { name: 'Use pika.jpg' })).toBeAttached();
  await idle(page);
  expect(await picture(page)).not.toBe(before);
  expect((await contents(page)).photos).toEqual(expect.arrayContaining(['pika.jpg', 'palace.jpg']));
  await press(page, 'Undo');
  await expect(page.getByRole('checkbox', { name: 'Use pika.jpg' })).toHaveCount(0);
  expect(await picture(page)).toBe(before);
});

test('an unused photo leaves the page, and a removed photo leaves the tray', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('checkbox', { name: 'Use cat.jpg' }).uncheck();
  await idle(page);
  expect((await contents(page)).photos).not.toContain('cat.jpg');
  await page.getByRole('checkbox', { name: 'Use cat.jpg' }).check();
  await idle(page);
  expect((await contents(page)).photos).toContain('cat.jpg');
  await page.getByRole('checkbox', { name: 'Use bee.jpg' }).hover();
  await press(page, 'Remove bee.jpg');
  await expect(page.getByRole('checkbox', { name: 'Use bee.jpg' })).toHaveCount(0);
  expect((await contents(page)).photos).not.toContain('bee.jpg');
});
