// @ts-check
import { readFile } from 'node:fs/promises';
import { add, colours, contents, expect, idle, photos, picture, pixelsOf, press, test } from '../support.js';

const DATA = new URL('../../../oracles/data/', import.meta.url);

/** @param {string} path @param {string} [name] @returns {Promise<{ name: string, mimeType: string, buffer: Buffer }>} */
async function file(path, name = path.split('/').at(-1) ?? path) {
  return { name, mimeType: `image/${name.split('.').at(-1)}`, buffer: await readFile(new URL(path, DATA)) };
}

/** @param {import('../support.js').Page} page @param {RegExp} name */
const boxes = (page, name) => page.getByRole('checkbox', { name });

test('an AVIF photo, which the browser decodes, becomes a panel and is exported from its file', async ({ page }) => {
  await page.goto('./');
  await add(page, [await file('foreign/plain.avif')]);
  await idle(page);
  await expect(page.getByRole('group', { name: 'Panel 1 of 1' })).toBeVisible();
  expect((await contents(page)).photos).toContain('plain.avif');
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download PNG' }).click(),
  ]);
  expect(await download.path()).toBeTruthy();
});

test('a HEIC photo that this browser cannot read is named with a way out, and the rest go on', async ({ page }) => {
  const heic = Buffer.from('\0\0\0\x18ftypheic\0\0\0\0mif1heic'.padEnd(400, 'x'), 'latin1');
  await page.goto('./');
  await add(page, [
    { name: 'phone.heic', mimeType: 'image/heic', buffer: heic },
    ...(await photos('bee.jpg', 'cat.jpg')),
  ]);
  await idle(page);
  await expect(page.getByRole('alert').getByText(/phone\.heic: .*HEIC.*JPEG/)).toBeVisible();
  await expect(boxes(page, /^Use phone/)).toHaveCount(0);
  await press(page, 'Shuffle');
});

for (const name of ['kept.gif', 'lossless.webp']) {
  test(`the pictures of ${name}, which moves, are frames as those of a film are`, async ({ page }) => {
    await page.goto('./');
    await add(page, [await file(`animations/${name}`), ...(await photos('pagoda.jpg'))]);
    await idle(page);
    // Six pictures of uneven length: four of them are shown at one of six even times.
    await expect(boxes(page, new RegExp(`^Use ${name}, 0:00`))).toHaveCount(4);
    await expect(boxes(page, /^Use pagoda/)).toBeChecked();
    expect((await contents(page)).photos.some((shown) => shown?.startsWith(name))).toBe(true);
    await press(page, 'Shuffle');
  });
}

test('other pictures are taken of an animation, and one undo brings the old ones back', async ({ page }) => {
  await page.goto('./');
  await add(page, [await file('animations/kept.gif')]);
  await idle(page);
  const taken = boxes(page, /^Use kept\.gif, 0:00/);
  const names = () => taken.evaluateAll((all) => all.map((box) => box.getAttribute('aria-label')));
  const before = await names();
  expect(before.length).toBe(4);
  await page.getByText(/^\d+ frames$/).click();
  await page.getByRole('slider', { name: 'Frames from the film' }).fill('2');
  await page.getByRole('button', { name: 'Take these frames' }).click();
  await expect(taken).toHaveCount(2);
  await idle(page);
  await press(page, 'Undo');
  expect(await names()).toEqual(before);
  await expect(page.getByRole('group', { name: 'Panel 1 of' }).first()).toBeVisible();
});

for (const name of ['gif.gif', 'webp-lossy.webp', 'webp-lossless.webp']) {
  test(`${name}, which does not move, is a photo`, async ({ page }) => {
    await page.goto('./');
    await add(page, [await file(`files/${name}`)]);
    await idle(page);
    await expect(boxes(page, new RegExp(`^Use ${name}$`))).toHaveCount(1);
    expect((await contents(page)).photos).toContain(name);
    expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
  });
}

test('an animation that breaks off gives the pictures that are whole; one without any is named', async ({ page }) => {
  const whole = await file('animations/kept.gif');
  const part = { ...whole, name: 'part.gif', buffer: whole.buffer.subarray(0, Math.floor(whole.buffer.length * 0.8)) };
  const none = {
    ...whole,
    name: 'none.gif',
    buffer: Buffer.concat([whole.buffer.subarray(0, 30), Buffer.from('rest of nothing')]),
  };
  await page.goto('./');
  await add(page, [part, none, ...(await photos('bee.jpg'))]);
  await idle(page);
  await expect(page.getByRole('alert').getByText(/none\.gif: .{8,}/)).toBeVisible();
  expect(await boxes(page, /^Use part\.gif/).count()).toBeGreaterThan(2);
});
