// @ts-check
/** Thumbnails that are seen larger by a finger that stays on them. */
import { FOUR } from '../designer-hands.js';
import { expect, openBoard, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

/** A finger that is put down, and lifted later. @param {Page} page @param {ReturnType<Page['locator']>} element */
async function finger(page, element) {
  await element.scrollIntoViewIfNeeded();
  const box = await element.boundingBox();
  if (!box) throw new Error('it is not shown');
  const client = await page.context().newCDPSession(page);
  const at = { x: box.x + box.width / 2, y: box.y + Math.min(box.height, 60) / 2 };
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [at] });
  return {
    box,
    moveBy: (/** @type {number} */ by) =>
      client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ ...at, y: at.y + by }] }),
    lift: () => client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] }),
  };
}

const seen = (/** @type {Page} */ page) => page.locator('.glimpse [data-drawn=true]');

test('a finger that stays on a style shows the page in it, and chooses nothing', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Styles', exact: true }).tap();
  const styles = page.getByRole('listbox', { name: 'Styles' });
  const chosen = styles.getByRole('option', { selected: true });
  const before = String(await chosen.getAttribute('aria-label'));
  const option = styles.locator('[role=option][aria-selected=false]').nth(3);
  const name = String(await option.getAttribute('aria-label'));
  const held = await finger(page, option);
  await expect(seen(page)).toBeVisible();
  const larger = await seen(page).boundingBox();
  expect(Number(larger?.height)).toBeGreaterThan(1.4 * held.box.height);
  await held.lift();
  await expect(seen(page)).toHaveCount(0);
  await page.waitForTimeout(100);
  await expect(chosen).toHaveAccessibleName(before);
  await styles.getByRole('option', { name, exact: true }).tap();
  await expect(chosen).toHaveAccessibleName(name);
});

test('a finger that stays on a tile of the explorer shows it large, and opens nothing', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Styles', exact: true }).tap();
  await page.getByRole('button', { name: 'Explorer', exact: true }).tap();
  const region = page.getByRole('region', { name: 'Style explorer' });
  await expect.poll(() => region.getByRole('listitem').count()).toBeGreaterThan(12);
  await expect(region).toHaveAttribute('aria-busy', 'false', { timeout: 60_000 });
  const picture = region
    .getByRole('listitem')
    .first()
    .getByRole('button', { name: /^Enlarge/ });
  const held = await finger(page, picture);
  await expect(seen(page)).toBeVisible();
  await held.lift();
  await expect(seen(page)).toHaveCount(0);
  await expect(page.getByRole('dialog')).toHaveCount(0);
  // A finger that moves on scrolls.
  const moving = await finger(page, picture);
  await moving.moveBy(-40);
  await page.waitForTimeout(600);
  await expect(seen(page)).toHaveCount(0);
  await moving.lift();
  await picture.tap();
  await expect(page.getByRole('dialog', { name: /^Large view of/ })).toBeVisible();
});
