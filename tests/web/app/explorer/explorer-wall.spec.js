// @ts-check
/** The wall of styles in the explorer. */
import { FOUR } from '../style-designer.js';
import { accessible, contents, expect, idle, openBoard, picture, step, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page */
const region = (page) => page.getByRole('region', { name: 'Style explorer' });
/** @param {Page} page */
const wall = (page) => region(page).getByRole('listitem');
/** @param {Page} page */
const large = (page) => page.getByRole('dialog', { name: /^Large view of/ });

/** @param {Page} page */
async function opened(page) {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
}

/** Waits until the wall is complete. @param {Page} page */
async function whole(page) {
  await expect.poll(() => wall(page).count()).toBeGreaterThan(0);
  await expect(region(page)).toHaveAttribute('aria-busy', 'false', { timeout: 180_000 });
}

/** @param {Page} page @returns {Promise<string[]>} */
const order = (page) => wall(page).evaluateAll((list) => list.map((item) => String(item.getAttribute('data-style'))));

/** @param {Page} page @param {number} n @returns {Promise<string>} */
const tile = (page, n) =>
  wall(page)
    .nth(n)
    .locator('canvas')
    .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());

/**
 * Returns the minimum mean difference of two tiles, over a grid of colours and roughness. The core uses a similar measure.
 * @param {Page} page
 */
const leastDistance = (page) =>
  wall(page)
    .locator('canvas')
    .evaluateAll((canvases) => {
      const [columns, rows] = [12, 9];
      const signatures = canvases.map((element) => {
        const canvas = /** @type {HTMLCanvasElement} */ (element);
        const { width, height } = canvas;
        const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(
          0,
          0,
          width,
          height,
        );
        const sums = new Float64Array(columns * rows * 5);
        const luma = (/** @type {number} */ at) => 0.299 * data[at] + 0.587 * data[at + 1] + 0.114 * data[at + 2];
        for (let y = 0; y < height; y += 1) {
          for (let x = 0; x < width; x += 1) {
            const cell = 5 * (Math.floor((y * rows) / height) * columns + Math.floor((x * columns) / width));
            const at = 4 * (y * width + x);
            for (let c = 0; c < 3; c += 1) sums[cell + c] += data[at + c];
            if (x > 0) sums[cell + 3] += 4 * Math.abs(luma(at) - luma(at - 4));
            sums[cell + 4] += 1;
          }
        }
        return Array.from({ length: columns * rows * 4 }, (_, i) => {
          const cell = 5 * Math.floor(i / 4);
          return Math.min(255, sums[cell + (i % 4)] / sums[cell + 4]);
        });
      });
      let least = 255;
      signatures.forEach((a, i) => {
        for (const b of signatures.slice(i + 1))
          least = Math.min(least, a.reduce((sum, value, k) => sum + Math.abs(value - b[k]), 0) / a.length);
      });
      return least;
    });

test('a wall of styles is filtered, enlarged, drawn on another photo and extended', async ({ page }) => {
  test.slow();
  await opened(page);
  await whole(page);

  await step(page, 'the first wall starts without a click and can be stopped', async () => {
    expect(await wall(page).count()).toBeGreaterThan(60);
    await page.getByRole('button', { name: 'Generate' }).click();
    await expect(page.getByRole('progressbar', { name: /Generating styles/ })).toBeVisible();
    await page.getByRole('button', { name: 'Stop' }).click();
    await expect(region(page)).toHaveAttribute('aria-busy', 'false');
    const before = await order(page);
    await page.getByRole('button', { name: 'Back to the page' }).click();
    await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
    await expect(wall(page)).toHaveCount(before.length);
    expect(await order(page)).toEqual(before);
  });

  await step(page, 'styles are filtered by hue and lightness', async () => {
    const all = await wall(page).count();
    for (const [group, least] of /** @type {const} */ ([
      ['Colour', 5],
      ['Lightness', 2],
    ])) {
      const kinds = region(page).getByRole('group', { name: group }).getByRole('button');
      let [sum, some] = [0, 0];
      for (const kind of await kinds.all()) {
        await kind.click();
        await expect(kind).toHaveAttribute('aria-pressed', 'true');
        const count = await wall(page).count();
        sum += count;
        some += count > 0 ? 1 : 0;
        await kind.click();
      }
      expect(sum).toBe(all);
      expect(some).toBeGreaterThanOrEqual(least);
    }
    await expect(wall(page)).toHaveCount(all);
  });

  await step(page, 'a style is enlarged under the pointer and with the focus', async () => {
    const seen = page.locator('.glimpse [data-drawn=true]');
    await wall(page).nth(9).hover();
    await expect(seen).toBeVisible();
    const [small, larger] = [await wall(page).nth(9).boundingBox(), await seen.boundingBox()];
    expect(Number(larger?.width)).toBeGreaterThan(1.5 * Number(small?.width));
    await page.mouse.move(5, 5);
    await expect(seen).toHaveCount(0);
    await region(page).getByRole('button', { name: 'Light', exact: true }).focus();
    await page.keyboard.press('Tab');
    await expect(
      wall(page)
        .first()
        .getByRole('button', { name: /^Enlarge/ }),
    ).toBeFocused();
    await expect(seen).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(seen).toHaveCount(0);
    // Escape also closes the explorer.
    await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
    await whole(page);
  });

  await step(page, 'a click opens the large view with keys for its neighbours, and Use applies the style', async () => {
    const names = await wall(page).evaluateAll((list) => list.map((item) => String(item.getAttribute('aria-label'))));
    await wall(page).nth(2).click();
    await expect(large(page)).toHaveAccessibleName(`Large view of ${names[2]}`);
    await expect(large(page)).toContainText(`3 of ${names.length}`);
    const canvas = large(page).getByRole('img', { name: new RegExp(`^${names[2]} on `) });
    await expect(canvas.locator('..')).toHaveAttribute('aria-busy', 'false');
    const { width = 0, height = 0 } = (await canvas.boundingBox()) ?? {};
    expect(Math.max(width, height)).toBeGreaterThan(500);
    const size = await canvas.evaluate((element) => /** @type {HTMLCanvasElement} */ (element).width);
    expect(size).toBeGreaterThanOrEqual(Math.floor(width));
    await accessible(page);

    await page.keyboard.press('ArrowRight');
    await expect(large(page)).toHaveAccessibleName(`Large view of ${names[3]}`);
    await large(page).getByRole('button', { name: 'Previous style' }).click();
    await page.keyboard.press('ArrowLeft');
    await expect(large(page)).toHaveAccessibleName(`Large view of ${names[1]}`);
    await page.keyboard.press('ArrowLeft');
    await expect(large(page).getByRole('button', { name: 'Previous style' })).toBeDisabled();
    await page.keyboard.press('ArrowLeft');
    await expect(large(page)).toHaveAccessibleName(`Large view of ${names[0]}`);
    await page.keyboard.press('Escape');
    await expect(large(page)).toHaveCount(0);
    await expect(region(page)).toBeVisible();
    // The style that was shown last.
    const first = wall(page)
      .first()
      .getByRole('button', { name: `Enlarge ${names[0]}` });
    await expect(first).toBeFocused();

    const before = await picture(page);
    await page.keyboard.press('Enter');
    await expect(large(page)).toHaveAccessibleName(`Large view of ${names[0]}`);
    await page.keyboard.press('ArrowRight');
    await expect(large(page)).toHaveAccessibleName(`Large view of ${names[1]}`);
    await large(page).getByRole('button', { name: 'Use', exact: true }).click();
    await idle(page);
    await expect(region(page)).toHaveCount(0);
    expect(await picture(page)).not.toBe(before);
    expect((await contents(page)).style).toBe(names[1]);
    await page.getByRole('button', { name: 'Undo', exact: true }).click();
    await idle(page);
    await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
    await whole(page);
  });

  await step(page, 'the wall is drawn on another photo, with each style at its place', async () => {
    const [before, first] = [await order(page), await tile(page, 0)];
    const photos = region(page).getByRole('group', { name: 'Photo of the gallery' });
    await expect(photos.getByRole('button')).toHaveCount(FOUR.length);
    const other = photos.locator('button:not([aria-current])').first();
    await other.click();
    await whole(page);
    const after = await order(page);
    expect(after).toEqual(before.filter((id) => after.includes(id)));
    expect(after.length).toBeGreaterThan(before.length / 2);
    expect(await tile(page, 0)).not.toBe(first);
    expect(await leastDistance(page)).toBeGreaterThan(6);
    // The large view shows the other photo too.
    const name = String(await photos.locator('button[aria-current]').getAttribute('title'));
    await wall(page).first().click();
    await expect(large(page).getByRole('img')).toHaveAccessibleName(new RegExp(` on ${name}$`));
    await page.keyboard.press('Escape');
    await expect(large(page)).toHaveCount(0);
  });

  await step(page, 'no two styles look the same after two rounds and two breedings, and none moves', async () => {
    const before = await order(page);
    await page.getByRole('button', { name: 'Generate' }).click();
    await expect.poll(async () => (await order(page)).length).toBeGreaterThan(before.length);
    expect((await order(page)).slice(0, before.length)).toEqual(before);
    await whole(page);
    const box = await wall(page).first().boundingBox();
    for (const [a, b] of [
      [0, 3],
      [1, 5],
    ]) {
      for (const n of [a, b]) {
        await wall(page).nth(n).hover();
        await wall(page).nth(n).getByRole('button', { name: 'Combine' }).click();
      }
      await whole(page);
    }
    // Messages above the wall do not move it.
    expect(await wall(page).first().boundingBox()).toEqual(box);
    expect(await wall(page).filter({ hasText: 'Combines' }).count()).toBeGreaterThan(5);
    // The core requires 7 for its own small copies.
    expect(await leastDistance(page)).toBeGreaterThan(6);
  });
});
