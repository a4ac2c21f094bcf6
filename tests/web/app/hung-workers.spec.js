// @ts-check
/** Workers that hang: they cost seconds, and no photo where the next worker can read it. */

import { test as plain } from '../../../www/testing.ts';
import { SIX, add, colours, expect, idle, photos, picture, pixelsOf, press } from './support.js';

const WORKER = /assets\/worker-[^/]*\.js$/;
/** What a worker costs that hangs was half a minute before; now it is some seconds on an idle machine. */
const SECONDS = 25_000;

/**
 * Lets workers hang for ever in the middle of the third photo.
 * @param {import('./support.js').Page} page
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
        if (String(value?.id).endsWith('-3') && value.work) for (;;);
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
