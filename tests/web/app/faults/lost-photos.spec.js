// @ts-check
import { copyFile, mkdir, rename } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { test as plain } from '../../../../www/testing.ts';
import {
  SIX,
  add,
  colours,
  contents,
  expect,
  idle,
  openBoard,
  photos,
  picture,
  pixelsOf,
  press,
  test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

const PHOTOS = new URL('../../../photos/', import.meta.url);

/**
 * Makes every worker of the pool fail in the way of `fault` when it is about to answer for a photo whose id ends so.
 * @param {Page} page
 * @param {string} fault an expression
 * @param {string} id
 * @param {string} [unless] an expression
 */
const sabotage = (page, fault, id, unless = 'false') =>
  page.route(/assets\/worker-[^/]*\.js$/, async (route) => {
    const response = await route.fetch();
    const script = `{
    const { parse } = JSON;
    JSON.parse = (text, ...rest) => {
      const value = parse(text, ...rest);
      if (String(value?.meta?.id).endsWith('${id}') && value.work && !(${unless})) throw ${fault};
      return value;
    };
  }`;
    await route.fulfill({ response, body: `${script}\n${await response.text()}` });
  });

const TRAP = "new WebAssembly.RuntimeError('unreachable')";
const FULL = "new RangeError('Array buffer allocation failed')";

for (const [what, fault] of [
  ['traps', TRAP],
  ['runs out of memory', FULL],
]) {
  plain(
    `a photo on which the program ${what} each time is named and left out, and the rest go on`,
    async ({ page }) => {
      await sabotage(page, fault, '-3');
      await page.goto('./');
      await add(page, await photos(...SIX));
      await idle(page);
      await expect(page.getByRole('alert').getByText(/crab\.jpg: .{8,}/)).toBeVisible();
      await expect(page.getByRole('checkbox', { name: 'Use crab.jpg' })).toHaveCount(0);
      for (const name of SIX.filter((other) => other !== 'crab.jpg'))
        await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeChecked();
      expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
      await page.unroute(/assets\/worker-[^/]*\.js$/);
      await press(page, 'Shuffle');
    },
  );
}

test('a photo that vanished from the disk is named when the page is saved, and saving works once it is back', async ({
  page,
}, info) => {
  const folder = info.outputPath('photos');
  await mkdir(folder, { recursive: true });
  const paths = SIX.slice(0, 3).map((name) => `${folder}/${name}`);
  await Promise.all(paths.map((path, i) => copyFile(fileURLToPath(new URL(SIX[i], PHOTOS)), path)));
  await page.goto('./');
  await page.getByLabel('Photos or video').setInputFiles(paths);
  await idle(page);
  const [before, shown] = [await picture(page), await contents(page)];
  await rename(paths[1], `${paths[1]}.gone`);
  await page.getByRole('button', { name: 'Download PNG' }).click();
  await expect(page.getByRole('alert')).toContainText(/cat\.jpg: the file was moved, changed or deleted/);
  expect(await picture(page)).toBe(before);
  expect(await contents(page)).toEqual(shown);
  await rename(`${paths[1]}.gone`, paths[1]);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download PNG' }).click(),
  ]);
  expect(await download.path()).toBeTruthy();
});

test('a photo that vanishes before it is read is named, and the page is made of the others', async ({ page }, info) => {
  const folder = info.outputPath('photos');
  await mkdir(folder, { recursive: true });
  const paths = SIX.slice(0, 3).map((name) => `${folder}/${name}`);
  await Promise.all(paths.map((path, i) => copyFile(fileURLToPath(new URL(SIX[i], PHOTOS)), path)));
  /** @type {() => void} */
  let loaded = () => {};
  const held = new Promise((/** @type {(value?: any) => void} */ resolve) => (loaded = resolve));
  await page.route('**/*.wasm', async (route) => {
    await held;
    await route.continue();
  });
  await page.goto('./');
  await page.getByLabel('Photos or video').setInputFiles(paths);
  await rename(paths[2], `${paths[2]}.gone`);
  loaded();
  await idle(page);
  await expect(page.getByRole('alert')).toContainText(/crab\.jpg: the file was moved, changed or deleted/);
  expect(new Set((await contents(page)).photos)).toEqual(new Set(['bee.jpg', 'cat.jpg']));
});

plain('workers that die while the page is saved are replaced, and the file comes', async ({ page }) => {
  await openBoard(page);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download PNG' }).click();
  await Promise.all(
    page.workers().map((worker) =>
      worker
        .evaluate(() => {
          setTimeout(() => {
            throw new Error('a fault made by the test');
          });
        })
        .catch(() => {}),
    ),
  );
  const outcome = await Promise.race([
    saved,
    page
      .getByRole('alert')
      .getByText(/could not be made/)
      .waitFor()
      .then(() => null),
  ]);
  // What was handed over to a worker is gone with it: then the message says so, and the next try is a good one.
  const again =
    outcome ??
    (await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download PNG' }).click()]))[0];
  expect(await again.path()).toBeTruthy();
});

test('a tab that is frozen in the background goes on where it was', async ({ page, context }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  const session = await context.newCDPSession(page);
  await session.send('Page.setWebLifecycleState', { state: 'frozen' });
  await new Promise((resolve) => setTimeout(resolve, 3000));
  await session.send('Page.setWebLifecycleState', { state: 'active' });
  await idle(page);
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeAttached();
  await expect(page.getByRole('alert')).toHaveText('');
  await press(page, 'Shuffle');
});

test('minutes that pass at once while nothing is answered lose no photo', async ({ page }) => {
  await page.clock.install();
  await page.goto('./');
  await add(page, await photos(...SIX));
  // A hidden tab's timers fire late and together when it comes back: the limit of a job must not take it for hung twice.
  await page.clock.fastForward('05:00');
  await page.clock.resume();
  await idle(page);
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeAttached();
});
