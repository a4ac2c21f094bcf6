// @ts-check
/** Projects and photos that are dropped together. */

import { saved } from '../export-dialog.js';
import { SIX, accessible, add, drop, expect, idle, openBoard, photos, test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** Names the open project and saves it as a file. @param {Page} page @param {string} name */
async function savedProject(page, name) {
  await page.getByLabel('Project name').fill(name);
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Projects', exact: true }).click();
  const file = await saved(page, () => page.getByRole('button', { name: 'Save project' }).click());
  await page.getByRole('button', { name: 'Back to the page' }).click();
  return { name: file.name, mimeType: '', buffer: file.bytes };
}

/** @param {Page} page */
const inTray = (page) =>
  page
    .getByRole('checkbox', { name: /^Use / })
    .evaluateAll((boxes) => boxes.map((box) => box.getAttribute('aria-label')?.replace('Use ', '')));

test('two projects and a photo that are dropped together are all opened', async ({ page, browser, baseURL }) => {
  await openBoard(page, SIX.slice(0, 2));
  const alpha = await savedProject(page, 'Alpha');
  await add(page, await photos(SIX[2]));
  await idle(page);
  const beta = await savedProject(page, 'Beta');
  const other = await (
    await browser.newContext({ baseURL, serviceWorkers: 'block', viewport: { width: 1280, height: 800 } })
  ).newPage();
  await other.addInitScript(() => localStorage.setItem('inkpanel.detect', 'off'));
  await openBoard(other, SIX.slice(4, 5));
  await drop(other, [beta, ...(await photos(SIX[5])), alpha]);
  const status = other.locator('.toast-list[role=status]');
  await expect(status).toContainText('2 projects were opened separately. Beta is on the page; Alpha is in Projects.');
  await expect(status).toContainText('The photo from the same drop was added to Beta.');
  await idle(other);
  await expect(other.getByLabel('Project name')).toHaveValue('Beta');
  await expect.poll(() => inTray(other)).toEqual([...SIX.slice(0, 3), SIX[5]]);
  await accessible(other);
  await status.getByRole('button', { name: 'Open Alpha' }).click();
  await expect(other.getByLabel('Project name')).toHaveValue('Alpha');
  await expect.poll(() => inTray(other)).toEqual(SIX.slice(0, 2));
  await other.getByRole('button', { name: 'Projects', exact: true }).click();
  // The project from before is named after its date.
  for (const name of [/^Open Alpha$/, /^Open Beta$/, /^Open .*\d{4}$/])
    await expect(other.getByRole('button', { name })).toBeVisible();
  await other.context().close();
});
