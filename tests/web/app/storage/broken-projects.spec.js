// @ts-check
/** A project that cannot be shown: its last good version, its file, and other projects. `www/storage/broken.test.ts` has more damage. */

import { readFile } from 'node:fs/promises';
import { expectSaved } from '../project-files.js';
import { SIX, accessible, contents, expect, idle, openBoard, press, test } from '../support.js';
import { backUp, leave, spoil } from '../database.js';

/** @typedef {import('../support.js').Page} Page */

const broken = (/** @type {Page} */ page) => page.getByRole('group', { name: /cannot be shown/ });
const projects = (/** @type {Page} */ page) => page.getByRole('region', { name: 'Projects' });

/** Replaces the saved state, and loads the app. @param {Page} page @param {string} change */
async function loadDamaged(page, change) {
  await leave(page);
  await spoil(page, 'states', change);
  await page.goto('./');
  await idle(page);
}

/** Changes the page of the present state. @param {string} fields of the page */
const onPage = (fields) => `(() => {
  const kept = JSON.parse(new TextDecoder().decode(record.bytes));
  const { parts, present } = kept.history;
  present.page = parts.pages.push({ ...parts.pages[present.page], ${fields} }) - 1;
  return { ...record, bytes: new TextEncoder().encode(JSON.stringify(kept)) };
})()`;

test('a damaged project is restored or saved as a file, and other projects can be opened', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  await page.getByLabel('Project name').fill('Trip');
  await page.keyboard.press('Enter');
  await expectSaved(page);
  await press(page, 'Shuffle');
  await expectSaved(page);
  // A drawn state is written with the next edit.
  await press(page, 'Lock style');
  await expectSaved(page);
  const shown = await contents(page);
  await leave(page);
  await backUp(page);

  for (const [fields, why] of [
    ["words: Array(1000).fill({ kind: 'caption', text: 'MORE', panel: 0 })", 'it exceeds the limits of a project'],
    ['merges: [null]', 'part of it is damaged'],
  ]) {
    await test.step(`the last good version is restored: ${why}`, async () => {
      await loadDamaged(page, onPage(fields));
      await expect(broken(page)).toContainText(`Trip cannot be shown: ${why}.`);
      await accessible(page);
      await broken(page).getByRole('button', { name: 'Restore the last good version' }).click();
      await expect(page.getByRole('status').getByText('The last good version of Trip was restored.')).toBeVisible();
      await idle(page);
      expect(await contents(page)).toEqual(shown);
      await expectSaved(page);
      await page.reload();
      await idle(page);
      expect(await contents(page)).toEqual(shown);
      await expect(broken(page)).toHaveCount(0);
    });
  }

  await test.step('the photos and the text of the state are saved as a file', async () => {
    await loadDamaged(page, "({ id: record.id, version: 1, history: 'lost', facts: record.facts })");
    const download = page.waitForEvent('download');
    await broken(page).getByRole('button', { name: 'Save as file' }).click();
    const bytes = await readFile(await (await download).path());
    for (const name of ['project.json', ...SIX.slice(0, 3)]) expect(bytes.includes(name), name).toBe(true);
  });

  await test.step('a new project is started next to it', async () => {
    await broken(page).getByRole('button', { name: 'Open another' }).click();
    await expect(broken(page)).toBeVisible();
    await accessible(page);
    await expect(projects(page).getByRole('button', { name: 'Open Trip' })).toBeVisible();
    await page.getByRole('button', { name: 'Back to the page' }).click();
    await page.getByRole('button', { name: 'Try the sample album' }).click();
    await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
    await idle(page);
    await expectSaved(page);
  });

  await test.step('the open project stays if the damaged one is opened', async () => {
    const before = await contents(page);
    await page.getByRole('button', { name: 'Projects' }).click();
    await projects(page).getByRole('button', { name: 'Open Trip' }).click();
    await expect(broken(page)).toBeVisible();
    await page.getByRole('button', { name: 'Back to the page' }).click();
    expect(await contents(page)).toEqual(before);
    await page.reload();
    await idle(page);
    expect(await contents(page)).toEqual(before);
  });
});

test('without a project record, the app starts and lists the project', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  await expectSaved(page);
  await leave(page);
  await backUp(page);
  await spoil(page, 'projects', 'undefined');
  await page.goto('./');
  await idle(page);
  const start = page.getByRole('button', { name: 'Choose photos or a video' });
  await expect(start.or(page.getByRole('region', { name: 'Comic page' }))).toBeVisible();
  await page.getByRole('button', { name: 'Projects' }).click();
  await expect(projects(page).getByRole('listitem')).not.toHaveCount(0);
});
