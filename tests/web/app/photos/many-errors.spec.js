// @ts-check
/** What the page says when much goes wrong at once. */

import { test as plain } from '../../../../www/testing.ts';
import { SIX, accessible, add, expect, idle, openBoard, photos, press, test } from '../support.js';

/** @param {number} count */
const bad = (count) =>
  Array.from({ length: count }, (_, i) => ({
    name: `bad-${i + 1}.jpg`,
    mimeType: 'image/jpeg',
    buffer: Buffer.from(`no photo ${i}`),
  }));

test('many files that cannot be read are one message, with a list that keys and screen readers reach', async ({
  page,
}) => {
  await page.goto('./');
  await add(page, [...bad(9), ...(await photos(...SIX.slice(0, 2)))]);
  await idle(page);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('9 files could not be read.');
  await expect(alert.getByRole('button', { name: 'Dismiss' })).toHaveCount(1);
  await accessible(page);
  const open = alert.getByRole('button', { name: 'Show the list' });
  await open.focus();
  await page.keyboard.press('Enter');
  const list = page.getByRole('dialog', { name: '9 files could not be read.' });
  await expect(list.getByRole('listitem')).toHaveCount(9);
  for (let i = 1; i <= 9; i += 1)
    await expect(list.getByRole('listitem').nth(i - 1)).toHaveText(new RegExp(`^bad-${i}\\.jpg.{8,}`));
  await accessible(page);
  await page.keyboard.press('Escape');
  await expect(list).toBeHidden();
  await expect(open).toBeFocused();
  // Dismissed, it begins anew with the next.
  await alert.getByRole('button', { name: 'Dismiss' }).click();
  await expect(alert).toHaveText('');
  await add(page, [{ ...bad(1)[0], name: 'other.jpg' }]);
  await expect(alert).toContainText(/^other\.jpg: .{8,}/);
});

// Not the watched test: a database that refuses is on the console, too.
plain('that work is not saved stays in sight, first of all, whatever else goes wrong', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 640 });
  await page.addInitScript(() => {
    localStorage.setItem('inkpanel.detect', 'off');
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('no room', 'QuotaExceededError');
    };
  });
  await openBoard(page, SIX.slice(0, 2));
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await press(page, 'Shuffle');
  const alert = page.getByRole('alert');
  const grave = alert.getByText('Your work is not saved');
  await expect(grave).toBeVisible();
  for (let i = 0; i < 40; i += 1) {
    await add(page, [
      { name: `${i}.srt`, mimeType: 'text/plain', buffer: Buffer.from('no time') },
      { name: `${i}.inkpanel`, mimeType: '', buffer: Buffer.from('no ZIP') },
    ]);
  }
  await add(page, bad(34));
  await idle(page);
  await expect(alert).toContainText(/\d+ files could not be read/);
  await expect(grave).toBeInViewport();
  const [top, first] = await Promise.all([grave.boundingBox(), alert.locator('.toast').first().innerText()]);
  expect(first).toContain('Your work is not saved');
  // The way on is there, and nothing lies over it.
  await alert.getByRole('button', { name: 'Save to file' }).click({ trial: true });
  expect(top).not.toBeNull();
});

test('subtitles that are a wall of marks are answered like others', async ({ page }) => {
  await page.goto('./');
  const wall = `00:00:01,000 --> 00:00:02,000\n${'<'.repeat(4_900_000)}`;
  await add(page, [
    { name: 'wall.srt', mimeType: 'text/plain', buffer: Buffer.from(wall) },
    { name: 'large.srt', mimeType: 'text/plain', buffer: Buffer.alloc(5_000_001, '1\n') },
  ]);
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('2 files could not be read.');
  await alert.getByRole('button', { name: 'Show the list' }).click();
  await expect(page.getByRole('listitem').filter({ hasText: /^wall\.srt.*there is no page yet/ })).toBeVisible();
  await expect(page.getByRole('listitem').filter({ hasText: /^large\.srt.*larger than 5 MB/ })).toBeVisible();
});
