// @ts-check
/** A long press on a thumbnail shows it large. */
import { FOUR } from '../style-designer.js';
import { expect, openBoard, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

/** Puts a finger on an element, to be lifted later. @param {Page} page @param {ReturnType<Page['locator']>} element */
async function finger(page, element) {
  await element.scrollIntoViewIfNeeded();
  const box = await element.boundingBox();
  if (!box) throw new Error('the element is not visible');
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

test('a long press on a style shows the page in this style, and applies nothing', async ({ page }) => {
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
  await expect(chosen).toHaveAccessibleName(before);
  await styles.getByRole('option', { name, exact: true }).tap();
  await expect(chosen).toHaveAccessibleName(name);
});

test('a long press on a style of the explorer shows it large and opens nothing, and a tap opens it, also while the app is busy', async ({
  page,
}) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Menu', exact: true }).tap();
  await page.getByRole('button', { name: 'Explore styles', exact: true }).tap();
  const region = page.getByRole('region', { name: 'Style explorer' });
  await expect.poll(() => region.getByRole('listitem').count()).toBeGreaterThan(12);
  await expect(region).toHaveAttribute('aria-busy', 'false', { timeout: 180_000 });
  const picture = region
    .getByRole('listitem')
    .first()
    .getByRole('button', { name: /^Enlarge/ });
  const held = await finger(page, picture);
  await expect(seen(page)).toBeVisible();
  await held.lift();
  await expect(seen(page)).toHaveCount(0);
  await expect(page.getByRole('dialog')).toHaveCount(0);
  const dialog = page.getByRole('dialog', { name: /^Large view of/ });
  await picture.tap();
  await expect(dialog).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  // The finger was lifted at once, and the app was too busy to notice it before the timer ended.
  const lift = await picture.evaluateHandle((element) => {
    const touch = { bubbles: true, pointerType: 'touch', isPrimary: true };
    element.dispatchEvent(new PointerEvent('pointerdown', touch));
    return new PointerEvent('pointerup', touch);
  });
  await expect(seen(page)).toBeVisible();
  await picture.evaluate((element, event) => {
    element.dispatchEvent(/** @type {Event} */ (event));
    /** @type {HTMLElement} */ (element).click();
  }, lift);
  await expect(dialog).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  // A swipe scrolls, even if the finger stays on the screen after it. The clock is also the clock of events, so it is last.
  await page.clock.install();
  const moving = await finger(page, picture);
  await moving.moveBy(-40);
  await page.clock.runFor(2_000);
  await expect(seen(page)).toHaveCount(0);
  await moving.lift();
});
