// @ts-check
/** Workers that hang are terminated, and their photos are read by the next worker. */

import {
  SIX,
  add,
  colours,
  expect,
  faultTest as test,
  idle,
  openBoard,
  photos,
  picture,
  pixelsOf,
  press,
} from '../support.js';

const WORKER = /assets\/worker-[^/]*\.js$/;
/** Detection takes seconds on an idle machine. */
const PATIENCE = { timeout: 150_000 };

/**
 * Lets workers hang while they read the third photo.
 * @param {import('../support.js').Page} page
 * @param {(load: number) => boolean} which whether the n-th worker hangs, counted from 1
 */
async function hang(page, which) {
  let loads = 0;
  await page.route(WORKER, async (route) => {
    const response = await route.fetch();
    loads += 1;
    const script = `{
      const { parse } = JSON;
      JSON.parse = (text, ...rest) => {
        const value = parse(text, ...rest);
        if (String(value?.meta?.id).endsWith('-3') && value.work) for (;;);
        return value;
      };
    }`;
    await route.fulfill({
      response,
      body: which(loads) ? `${script}\n${await response.text()}` : await response.text(),
    });
  });
}

test('a photo on which a worker hangs is read by the next worker', { tag: '@ci' }, async ({ page }) => {
  await page.goto('about:blank');
  const workers = await page.evaluate(() => Math.min(8, navigator.hardwareConcurrency));
  await hang(page, (load) => load <= workers);
  await page.goto('./');
  await add(page, await photos(...SIX));
  await expect(page.getByRole('checkbox', { name: 'Use crab.jpg' })).toBeChecked();
  await page.waitForFunction(() => document.body.dataset.idle === 'true', null, PATIENCE);
  await expect(page.getByRole('alert')).toHaveText('');
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeChecked();
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
});

test('a photo on which each worker hangs is reported, and the other photos are used', { tag: '@ci' }, async ({
  page,
}) => {
  await hang(page, () => true);
  await page.goto('./');
  await add(page, await photos(...SIX));
  const alert = page.getByRole('alert').getByText(/crab\.jpg: Inkpanel crashed twice while reading it/);
  await expect(alert).toBeVisible(PATIENCE);
  await idle(page);
  for (const name of SIX.filter((other) => other !== 'crab.jpg'))
    await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeChecked();
  await page.unroute(WORKER);
  await press(page, 'Shuffle');
});

test('Cancel terminates workers that hang during a download', { tag: '@ci' }, async ({ page }) => {
  // While the clock is paused, no time limit of the app terminates the workers.
  await page.clock.install();
  await page.addInitScript(() => {
    const ended = Object.assign(globalThis, { ended: 0 });
    const { terminate } = Worker.prototype;
    Worker.prototype.terminate = function () {
      ended.ended += 1;
      terminate.call(this);
    };
  });
  await page.goto('about:blank');
  const workers = await page.evaluate(() => Math.min(8, navigator.hardwareConcurrency));
  let loads = 0;
  await page.route(WORKER, async (route) => {
    const response = await route.fetch();
    loads += 1;
    const hang = "addEventListener('message', ({ data }) => { if (data.op === 'fullPanels') for (;;); });";
    await route.fulfill({ response, body: `${loads <= workers ? hang : ''}\n${await response.text()}` });
  });
  /** @type {string[]} */
  const downloads = [];
  page.on('download', (file) => downloads.push(file.suggestedFilename()));
  await openBoard(page);
  const ended = () => page.evaluate(() => /** @type {any} */ (globalThis).ended);
  const before = await ended();
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 1000));
  await page.getByRole('button', { name: 'Download PNG' }).click();
  const progress = page.getByRole('progressbar', { name: /full size/ });
  await expect(progress).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  // Workers have 50 ms to end. The time limits of jobs are longer than a second.
  await page.clock.runFor(200);
  await expect.poll(ended).toBeGreaterThan(before);
  await page.clock.resume();
  await expect(progress).toHaveCount(0);
  const waiting = page.waitForEvent('download', { timeout: 90_000 });
  await page.getByRole('button', { name: 'Download PNG' }).click();
  expect((await waiting).suggestedFilename()).toMatch(/\.png$/);
  expect(downloads).toHaveLength(1);
});
