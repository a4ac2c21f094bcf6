// @ts-check
/** A tab that the system kills: all work remains when the app is opened again. */

import { contents, expect, idle, openBoard, picture, press, test } from '../support.js';
import { boxOf, changed, drag, four } from '../panels.js';
import { openWords, word, write } from '../text-items.js';

/** @typedef {import('../support.js').Page} Page */

/** @param {Page} page */
async function kill(page) {
  const gone = new Promise((resolve) => page.once('crash', resolve));
  const client = await page.context().newCDPSession(page);
  // A crashed page does not answer.
  void client.send('Page.crash').catch(() => {});
  await gone;
}

/** @param {Page} page */
async function openedAgain(page) {
  const again = await page.context().newPage();
  await again.goto(page.url());
  await expect(again.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(again);
  return again;
}

test('all work remains after the tab is killed, including the last step', async ({ page }) => {
  await openBoard(page);
  await press(page, 'Shuffle');
  await write(page, 'balloon', 'Still here');
  await page.getByRole('button', { name: 'Lock style' }).click();
  await expect(page.locator('.save-state')).toHaveText('Saved');
  await press(page, 'Shuffle layout');
  const before = await contents(page);
  // The state of the last step is not stored yet.
  await kill(page);

  const again = await openedAgain(page);
  expect(await contents(again)).toEqual(before);
  await openWords(again);
  await expect(word(again, 'Balloon: Still here')).toBeVisible();
  await expect(again.getByRole('button', { name: 'Lock style' })).toHaveAttribute('aria-pressed', 'true');
  await expect(again.getByText('Version 3 of 3').or(again.getByText('3/3'))).toBeVisible();
  await again.getByRole('button', { name: 'Undo' }).click();
  await idle(again);
  expect((await contents(again)).layout).not.toBe(before.layout);
});

test('a drag that was never saved remains after the tab is killed, as one undo step', async ({ page }) => {
  await four(page);
  const { x, y } = await boxOf(page, 1);
  await page.mouse.move(x + 60, y + 60);
  await page.mouse.wheel(0, -240);
  await idle(page);
  await expect(page.locator('.save-state')).toHaveText('Saved');
  const near = await picture(page);
  await page.evaluate(() => {
    IDBObjectStore.prototype.put = () => {
      throw new Error('The disk has hiccups.');
    };
  });
  await drag(page, [x + 60, y + 60], [x + 20, y + 30]);
  const panned = await picture(page);
  expect(changed(near, panned)).toEqual([1]);
  await kill(page);

  const again = await openedAgain(page);
  expect(changed(panned, await picture(again))).toEqual([]);
  await press(again, 'Undo');
  expect(changed(near, await picture(again))).toEqual([]);
});

test('photos that were added right before the tab was killed remain, or are requested by name', async ({ page }) => {
  await openBoard(page, ['bee.jpg', 'cat.jpg', 'crab.jpg']);
  await kill(page);
  const again = await openedAgain(page);
  for (const name of ['bee.jpg', 'cat.jpg', 'crab.jpg']) await expect(again.getByText(name).first()).toBeVisible();
});
