// @ts-check
/** Stacks of look-alikes, the threshold for look-alikes, the order of the photos, and starred photos. */

import { reloadSaved } from '../project-files.js';
import { add, expect, idle, openBoard, photos, press, sharedBoardTest as test } from '../support.js';

/** @param {import('../support.js').Page} page */
async function openWithCopies(page) {
  await openBoard(page);
  const [cat] = await photos('cat.jpg');
  // The copies come later, because the first photo that was read represents the stack.
  await add(
    page,
    ['cat2.jpg', 'cat3.jpg'].map((name) => ({ ...cat, name })),
  );
  await idle(page);
}

test('a stack opens, another or several of its photos are used, and Undo restores the first', async ({ page }) => {
  await openWithCopies(page);
  const tray = page.getByRole('region', { name: 'Photos' });
  const use = (/** @type {string} */ name) => tray.getByRole('checkbox', { name: `Use ${name}`, exact: true });
  await expect(tray.getByText('sharpest of 3')).toBeVisible();
  await expect(use('cat2.jpg')).not.toBeChecked();
  await press(page, 'Show the 3 photos similar to cat.jpg');
  const stack = tray.getByRole('listitem').filter({ has: page.getByRole('button', { name: '3 similar' }) });
  await expect(stack.getByRole('checkbox')).toHaveCount(3);
  await expect(stack.getByText('These photos are similar.')).toBeVisible();
  const shown = await page.locator('.panel').count();
  await press(page, 'Use cat2.jpg instead');
  await expect(use('cat2.jpg')).toBeChecked();
  await expect(use('cat.jpg')).not.toBeChecked();
  expect(await page.locator('.panel').count()).toBe(shown);
  await use('cat3.jpg').check();
  await idle(page);
  await expect(use('cat2.jpg')).toBeChecked();
  await press(page, 'Undo');
  await press(page, 'Undo');
  await expect(use('cat.jpg')).toBeChecked();
  await expect(use('cat3.jpg')).not.toBeChecked();
  await press(page, '3 similar');
  await expect(stack).toHaveCount(0);
});

test('keyboard: a stack is opened and closed, the threshold and the order change', async ({ page }) => {
  await openWithCopies(page);
  const opener = page.getByRole('button', { name: 'Show the 3 photos similar to cat.jpg' });
  await opener.focus();
  await page.keyboard.press('Enter');
  const head = page.getByRole('button', { name: '3 similar' });
  await expect(head).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(opener).toBeVisible();
  await page.getByText('Photo selection').focus();
  await page.keyboard.press('Enter');
  const slider = page.getByRole('slider', { name: 'Exclude similar photos' });
  await expect(page.getByText('6 of 8 in use')).toBeVisible();
  await slider.focus();
  await page.keyboard.press('Home');
  await idle(page);
  await expect(slider).toHaveAttribute('aria-valuetext', /nearly identical/);
  // The copies have the same pixels.
  await expect(page.getByText('6 of 8 in use')).toBeVisible();
  const order = page.getByRole('combobox', { name: 'Order' });
  await order.selectOption('By file name');
  await idle(page);
  await press(page, 'Undo');
  await expect(order).toHaveValue('time');
});

test('a starred photo gets a panel that is no smaller, and the largest panel after Shuffle', async ({ page }) => {
  await openBoard(page);
  const tray = page.getByRole('region', { name: 'Photos' });
  const star = tray.getByRole('button', { name: 'Star cat.jpg' });
  /** Photos of the panels and the areas of these panels in square pixels. */
  const areas = () =>
    page.evaluate(() => {
      // A panel is a box that is clipped to a polygon in percent, or to a circle.
      const area = (/** @type {Element} */ one) => {
        const { width, height } = one.getBoundingClientRect();
        const { clipPath } = getComputedStyle(one);
        if (clipPath.startsWith('circle')) return (Math.PI / 4) * Math.min(width, height) ** 2;
        const points = [...clipPath.matchAll(/([\d.-]+)% ([\d.-]+)%/g)].map(([, x, y]) => [+x / 100, +y / 100]);
        const twice = points.reduce((sum, [x, y], i) => {
          const [nextX, nextY] = points[(i + 1) % points.length];
          return sum + x * nextY - nextX * y;
        }, 0);
        return (Math.abs(twice) / 2) * width * height;
      };
      const panels = [...document.querySelectorAll('.stage [aria-description]')];
      return panels.map((one) => ({ photo: String(one.getAttribute('aria-description')), area: area(one) }));
    });
  const largestOf = async () => Math.max(...(await areas()).map(({ area }) => area));
  const areaOfCat = async () =>
    Math.max(...(await areas()).filter(({ photo }) => photo.includes('cat.jpg')).map(({ area }) => area));
  const before = await areaOfCat();
  await tray
    .getByRole('listitem')
    .filter({ has: page.getByRole('button', { name: 'Star cat.jpg' }) })
    .hover();
  await star.click();
  await expect(star).toHaveAttribute('aria-pressed', 'true');
  await press(page, 'Undo');
  await expect(star).toHaveAttribute('aria-pressed', 'false');
  await press(page, 'Redo');
  expect(await areaOfCat()).toBeGreaterThan(0.99 * before);
  let large = 0;
  for (let i = 0; i < 8; i += 1) {
    await press(page, 'Shuffle');
    await idle(page);
    if ((await areaOfCat()) > 0.95 * (await largestOf())) large += 1;
  }
  expect(large).toBeGreaterThanOrEqual(7);
  await reloadSaved(page);
  await expect(star).toHaveAttribute('aria-pressed', 'true');
});
