// @ts-check
import { readFile } from 'node:fs/promises';
import { add, expect, idle, photos, test } from '../support.js';

const ODD = new URL('../../../videos/odd/', import.meta.url);

/** @param {string} name @param {string} [as] */
async function film(name, as = name) {
  return { name: as, mimeType: 'video/mp4', buffer: await readFile(new URL(name, ODD)) };
}

for (const [name, why] of /** @type {[string, RegExp][]} */ ([
  ['headless.mp4', /breaks off before the list of its frames/],
  ['hevc.mp4', /HEVC \(H\.265\).*Convert it to MP4 with H\.264/],
  ['prores.mov', /ProRes.*Convert it/],
  ['part2.avi', /AVI, MPEG-4 Part 2.*Convert it/],
  ['part2.mp4', /MPEG-4 Part 2.*Convert it/],
  ['theora.ogv', /Theora.*Convert it/],
  ['sound.mp4', /only sound/],
]))
  test(`${name} is named with the reason, once`, async ({ page }) => {
    await page.goto('./');
    await add(page, [await film(name)]);
    await expect(page.getByRole('alert').getByText(why)).toBeVisible();
    await expect(page.getByRole('alert').getByText(/None of these files/)).toHaveCount(0);
    await expect(page.getByRole('checkbox', { name: /^Use / })).toHaveCount(0);
  });

test('an empty file is named', async ({ page }) => {
  await page.goto('./');
  await add(page, [{ name: 'empty.mp4', mimeType: 'video/mp4', buffer: Buffer.alloc(0) }]);
  await expect(page.getByRole('alert').getByText(/empty\.mp4: there is no frame/)).toBeVisible();
});

for (const [name, reach] of /** @type {[string, RegExp][]} */ ([
  ['half.mp4', /only to 0:0[01]\.\d of 0:03/],
  ['half.webm', /only to 0:\d+\.\d of 0:38/],
]))
  test(`${name} gives what it has, and says how far it reaches`, async ({ page }) => {
    await page.goto('./');
    await add(page, [await film(name)]);
    await expect(page.getByRole('alert').getByText(reach)).toBeVisible();
    await idle(page);
    expect(await page.getByRole('checkbox', { name: /^Use half/ }).count()).toBeGreaterThanOrEqual(6);
  });

for (const name of ['variable.mp4', 'hdr.webm'])
  test(`${name} becomes a page`, async ({ page }) => {
    await page.goto('./');
    await add(page, [await film(name)]);
    await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
    await idle(page);
    await expect(page.getByRole('checkbox', { name: /^Use / })).toHaveCount(8);
  });

test('a file is what is in it: a film called a photo, and a photo called a film', async ({ page }) => {
  await page.goto('./');
  const [bee] = await photos('bee.jpg');
  await add(page, [
    { ...(await film('variable.mp4', 'holiday.jpg')), mimeType: 'image/jpeg' },
    { ...bee, name: 'bee.mp4', mimeType: 'video/mp4' },
  ]);
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: /^Use holiday\.jpg, 0:0/ })).toHaveCount(8);
  await expect(page.getByRole('checkbox', { name: 'Use bee.mp4' })).toBeChecked();
});
