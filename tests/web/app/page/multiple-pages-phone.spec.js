// @ts-check
/** Storyboards of several pages on a phone, by touch. */

import { strip, thumb, thumbs } from '../book-hands.js';
import { accessible, expect, idle, openBoard, picture, press, test } from '../support.js';
import { way } from '../touch-hands.js';

test.use({ viewport: { width: 360, height: 740 }, hasTouch: true });

test('pages are added, turned, moved and removed', async ({ page }) => {
  await openBoard(page);
  await press(page, 'Add page');
  await expect(thumbs(page)).toHaveCount(2);
  await page.getByRole('button', { name: 'Page tools' }).click();
  await accessible(page);
  await press(page, 'Move page earlier');
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  const first = await picture(page);
  await thumb(page, 2).tap();
  await idle(page);
  expect(await picture(page)).not.toBe(first);
  await press(page, 'Remove page');
  await expect(thumbs(page)).toHaveCount(0);
});

test('a page that is held moves with the finger', async ({ page }) => {
  await openBoard(page);
  for (let i = 0; i < 2; i += 1) await press(page, 'Add page');
  const [from, to] = [await thumb(page, 3).boundingBox(), await thumb(page, 1).boundingBox()];
  if (!from || !to) throw new Error('no pages');
  const client = await page.context().newCDPSession(page);
  const touch = (/** @type {string} */ type, /** @type {number[][]} */ points) =>
    client.send('Input.dispatchTouchEvent', {
      type: /** @type {any} */ (type),
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  const steps = way([from.x + from.width / 2, from.y + 20], [to.x + 4, to.y + 20]);
  await touch('touchStart', [steps[0]]);
  await expect(strip(page).locator('[data-carried="true"]')).toHaveCount(1);
  for (const step of steps) await touch('touchMove', [step]);
  await touch('touchEnd', []);
  await idle(page);
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
});
