// @ts-check
/** Faces and objects: detected after the first page, shown on request. The app also works without detection. */

import { add, expect, idle, openBoard, photos, press, detectingTest as test } from './support.js';

const SOME = ['camera.jpg', 'cat.jpg', 'horses.jpg', 'macaw.jpg'];

test('photos are looked at once the page is there, and what is found can be seen', async ({ page }) => {
  /** @type {string[]} */
  const early = [];
  page.on('request', (request) => {
    if (/onnx|detector/.test(request.url())) early.push(request.url());
  });
  await page.goto('./');
  await page.getByLabel('Photos or video').waitFor({ state: 'attached' });
  expect(early).toEqual([]);
  // A progress bar at the photos appears, perhaps for a moment, and disappears.
  const LINE = '.tray progress[aria-label^="Detecting faces"]';
  await page.evaluate((line) => {
    const seen = () => {
      if (document.querySelector(line)) document.documentElement.dataset.detecting = 'seen';
    };
    new MutationObserver(seen).observe(document.body, { attributes: true, childList: true, subtree: true });
  }, LINE);
  await add(page, await photos(...SOME));
  await idle(page);
  await expect(page.locator('html')).toHaveAttribute('data-detecting', 'seen');
  await expect(page.locator(LINE)).toHaveCount(0);
  expect(early.some((url) => url.endsWith('.onnx'))).toBe(true);
  await expect(page.locator('.subject-boxes')).toHaveCount(0);
  await press(page, 'Show subjects');
  const label = (/** @type {string} */ name) => page.locator(`.page .subject-boxes rect[data-label="${name}"]`);
  for (const name of ['face', 'cat', 'horse', 'bird']) expect(await label(name).count()).toBeGreaterThan(0);
  await expect(page.locator('.tray .chosen-crop')).toHaveCount(4);
  // The face is whole in its panel.
  const inside = await label('face')
    .first()
    .evaluate((box) => {
      const clip = document.querySelector((box.getAttribute('clip-path') ?? '').replace(/^url\((.*)\)$/, '$1'));
      const [face, panel] = [box, clip?.firstElementChild].map((rect) =>
        ['x', 'y', 'width', 'height'].map((name) => Number(rect?.getAttribute(name))),
      );
      return (
        face[0] >= panel[0] - 1 &&
        face[1] >= panel[1] - 1 &&
        face[0] + face[2] <= panel[0] + panel[2] + 1 &&
        face[1] + face[3] <= panel[1] + panel[3] + 1
      );
    });
  expect(inside).toBe(true);
  await press(page, 'Show subjects');
  await expect(page.locator('.subject-boxes')).toHaveCount(0);
});

test('without the nets the page is made all the same, and says so once', async ({ page }) => {
  await page.route('**/*.onnx', (route) => route.fulfill({ contentType: 'text/html', body: 'not here' }));
  await openBoard(page, SOME);
  await expect(page.getByText('Face detection is not available here')).toHaveCount(1);
  await press(page, 'Shuffle');
});
