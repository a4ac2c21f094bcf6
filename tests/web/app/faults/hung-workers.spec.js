// @ts-check
/** Workers that hang: they cost seconds, and no photo where the next worker can read it. */

import { test as plain } from '../../../../www/testing.ts';
import { SIX, add, colours, expect, idle, openBoard, photos, picture, pixelsOf, press } from '../support.js';

const WORKER = /assets\/worker-[^/]*\.js$/;
/** What a worker costs that hangs was half a minute before; now it is some seconds on an idle machine. */
const SECONDS = 25_000;

/**
 * Lets workers hang for ever in the middle of the third photo.
 * @param {import('../support.js').Page} page
 * @param {(load: number) => boolean} which of the worker's loads do so, counted from 1
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

plain('a photo on which a worker hung is read by the next worker, after seconds', async ({ page }) => {
  await page.goto('about:blank');
  const workers = await page.evaluate(() => Math.min(8, navigator.hardwareConcurrency));
  await hang(page, (load) => load <= workers);
  await page.goto('./');
  await add(page, await photos(...SIX));
  await expect(page.getByRole('checkbox', { name: 'Use crab.jpg' })).toBeChecked();
  await page.waitForFunction(() => document.body.dataset.idle === 'true', null, { timeout: SECONDS });
  await expect(page.getByRole('alert')).toHaveText('');
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeChecked();
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
});

plain('a photo on which every worker hangs is named after seconds, and the rest go on', async ({ page }) => {
  await hang(page, () => true);
  await page.goto('./');
  await add(page, await photos(...SIX));
  await expect(page.getByRole('alert').getByText(/crab\.jpg: reading it stopped the program twice/)).toBeVisible({
    timeout: SECONDS,
  });
  await idle(page);
  for (const name of SIX.filter((other) => other !== 'crab.jpg'))
    await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeChecked();
  await page.unroute(WORKER);
  await press(page, 'Shuffle');
});

/** Milliseconds after which a worker that hangs has not been given up yet for its silence, on the fastest machine. */
const SILENCE = 1_500;

plain('a cancelled download is given up at once by workers that are in the middle of it', async ({ page }) => {
  await page.addInitScript(() => {
    localStorage.setItem('inkpanel.detect', 'off');
    const times = Object.assign(globalThis, { clicked: 0, ended: /** @type {number[]} */ ([]) });
    addEventListener('click', () => (times.clicked = performance.now()), true);
    const { terminate } = Worker.prototype;
    Worker.prototype.terminate = function () {
      times.ended.push(performance.now());
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
  await openBoard(page);
  const ended = () => page.evaluate(() => /** @type {any} */ (globalThis).ended.length);
  const before = await ended();
  await page.getByRole('button', { name: 'Download PNG' }).click();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect.poll(ended).toBeGreaterThan(before);
  const took = await page.evaluate(() => {
    const { clicked, ended } = /** @type {{ clicked: number, ended: number[] }} */ (/** @type {any} */ (globalThis));
    return ended.filter((time) => time > clicked).map((time) => Math.round(time - clicked));
  });
  plain.info().annotations.push({ type: 'workers given up after ms', description: took.join(', ') });
  expect(took.length).toBeGreaterThan(0);
  expect(Math.max(...took)).toBeLessThan(SILENCE);
  const waiting = page.waitForEvent('download', { timeout: 90_000 });
  await page.getByRole('button', { name: 'Download PNG' }).click();
  expect((await waiting).suggestedFilename()).toMatch(/\.png$/);
});
