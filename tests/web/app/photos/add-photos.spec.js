// @ts-check
import {
  SIX,
  add,
  colours,
  contents,
  drop,
  expect,
  idle,
  openBoard,
  photos,
  picture,
  pixelsOf,
  test,
} from '../support.js';

test('the start says what to do, and opens from any sub-path', async ({ page }) => {
  await page.goto('./');
  await expect(page).toHaveTitle(/Inkpanel/);
  await expect(page.getByRole('heading', { level: 1 })).toContainText('Drop your photos');
  await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
  await expect(page.getByText('Nothing leaves this device.')).toBeVisible();
});

test('the button opens the file dialog', async ({ page }) => {
  await page.goto('./');
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Choose photos or a video' }).click();
  expect((await chooser).isMultiple()).toBe(true);
});

test('the sample album becomes a page', async ({ page }) => {
  await page.goto('./');
  await page.getByRole('button', { name: 'Try the sample album' }).click();
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  await expect(page.getByRole('region', { name: 'Photos' }).getByRole('checkbox')).not.toHaveCount(0);
  expect(await page.getByRole('region', { name: 'Photos' }).getByRole('checkbox').count()).toBeGreaterThanOrEqual(10);
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
});

test('photos dropped on the window become a page', async ({ page }) => {
  await page.goto('./');
  await drop(page, await photos(...SIX));
  await expect(page.getByRole('group', { name: /^Panel 1 of / })).toBeVisible();
  await idle(page);
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}`, exact: true })).toBeAttached();
  const { photos: shown } = await contents(page);
  expect(shown.length).toBeGreaterThan(0);
  expect(shown.every((name) => SIX.includes(String(name)))).toBe(true);
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
});

test('photos dropped on a page join it, and one undo takes them away again', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  const before = await picture(page);
  await drop(page, await photos('pika.jpg', 'palace.jpg'));
  await expect(page.getByRole('checkbox', { name: 'Use pika.jpg' })).toBeAttached();
  await idle(page);
  expect(await picture(page)).not.toBe(before);
  expect((await contents(page)).photos).toEqual(expect.arrayContaining(['pika.jpg', 'palace.jpg']));
  await page.getByRole('button', { name: 'Undo' }).click();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: 'Use pika.jpg' })).toHaveCount(0);
  expect(await picture(page)).toBe(before);
});

test('a pasted photo is added', async ({ page }) => {
  await page.goto('./');
  const [{ buffer }] = await photos('cat.jpg');
  await page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const data = new DataTransfer();
    data.items.add(new File([bytes], 'pasted.jpg', { type: 'image/jpeg' }));
    window.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data }));
  }, buffer.toString('base64'));
  await expect(page.getByRole('checkbox', { name: 'Use pasted.jpg' })).toBeAttached();
  await idle(page);
  expect((await contents(page)).photos[0]).toBe('pasted.jpg');
});

test('a photo that is unticked leaves the page, and a removed one the tray', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('checkbox', { name: 'Use cat.jpg' }).uncheck();
  await idle(page);
  expect((await contents(page)).photos).not.toContain('cat.jpg');
  await page.getByRole('checkbox', { name: 'Use cat.jpg' }).check();
  await idle(page);
  expect((await contents(page)).photos).toContain('cat.jpg');
  await page.getByRole('checkbox', { name: 'Use bee.jpg' }).hover();
  await page.getByRole('button', { name: 'Remove bee.jpg' }).click();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: 'Use bee.jpg' })).toHaveCount(0);
  expect((await contents(page)).photos).not.toContain('bee.jpg');
});

test('the same photo twice is set aside, with the reason', async ({ page }) => {
  await page.goto('./');
  const [cat, bee] = await photos('cat.jpg', 'bee.jpg');
  await add(page, [cat, bee, { ...cat, name: 'cat copy.jpg' }]);
  await idle(page);
  const twins = [
    page.getByRole('checkbox', { name: 'Use cat.jpg' }),
    page.getByRole('checkbox', { name: 'Use cat copy.jpg' }),
  ];
  const used = await Promise.all(twins.map((twin) => twin.isChecked()));
  expect(used.filter(Boolean).length).toBe(1);
  await expect(twins[used.indexOf(false)]).toHaveAccessibleDescription(/cat/);
});
