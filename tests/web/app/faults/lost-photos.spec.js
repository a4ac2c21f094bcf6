// @ts-check
/** Photos that crash the engine, that vanish from the disk, and work in frozen tabs. */

import { copyFile, mkdir, rename } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { download } from '../export-dialog.js';
import {
  SIX,
  add,
  colours,
  contents,
  expect,
  faultTest,
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
 * Lets each worker throw an error when it answers for the photo whose id has this end.
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
  faultTest(`a photo on which the engine ${what} is reported, and the other photos are used`, async ({ page }) => {
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
  });
}

test('a photo that vanishes from the disk is reported by Download, which works when the photo is back', async ({
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
  expect((await download(page)).path).toBeTruthy();
});

test('a photo that vanishes before it is read is reported, and the other photos are used', async ({ page }, info) => {
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

faultTest('workers that crash during a download are replaced, and the file is saved', async ({ page }) => {
  await openBoard(page);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download PNG' }).click();
  await Promise.all(
    page.workers().map((worker) =>
      worker
        .evaluate(() => {
          setTimeout(() => {
            throw new Error('an error of the test');
          });
        })
        .catch(() => {}),
    ),
  );
  const outcome = await Promise.race([
    saved,
    page
      .getByRole('alert')
      .getByText(/could not be created/)
      .waitFor()
      .then(() => null),
  ]);
  // Data that was transferred to a worker may be lost. Then a message reports it, and the next download works.
  expect(outcome ? await outcome.path() : (await download(page)).path).toBeTruthy();
});

test('a tab continues after it was frozen in the background', async ({ page, context }) => {
  await page.clock.install();
  await page.goto('./');
  await add(page, await photos(...SIX));
  const session = await context.newCDPSession(page);
  await session.send('Page.setWebLifecycleState', { state: 'frozen' });
  await session.send('Page.setWebLifecycleState', { state: 'active' });
  // The time that passed while the tab was frozen.
  await page.clock.fastForward('00:30');
  await page.clock.resume();
  await idle(page);
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeAttached();
  await expect(page.getByRole('alert')).toHaveText('');
  await press(page, 'Shuffle');
});

test('a pause of minutes while photos are read loses no photo', async ({ page }) => {
  await page.clock.install();
  await page.goto('./');
  await add(page, await photos(...SIX));
  // The timers of a hidden tab fire late and together. The time limit of a job must not count this as two hangs.
  await page.clock.fastForward('05:00');
  await page.clock.resume();
  await idle(page);
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeAttached();
});
