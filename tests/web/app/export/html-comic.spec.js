// @ts-check
/** An HTML comic, opened from its file: read panel by panel, by pages, and as text. */

import { writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { savedAs } from '../export-dialog.js';
import { accessible, expect, makePageSmall, openBoard, test } from '../support.js';
import { write } from '../text-items.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** The box of an element, in pixels. @param {Page} page @param {string} part its selector */
const boxOf = (page, part) =>
  page.evaluate((part) => {
    const { left, top, right, bottom } = /** @type {Element} */ (document.querySelector(part)).getBoundingClientRect();
    return { left, top, right, bottom };
  }, part);

/**
 * Checks that a panel fills the screen as far as its shape allows, and that the other panels are dimmed.
 * @param {Page} page
 * @param {number} panel from 0
 */
async function fills(page, panel) {
  const shape = `.current .shape[data-panel="${panel}"] polygon`;
  await expect(async () => {
    const [stage, box] = [await boxOf(page, 'main'), await boxOf(page, shape)];
    const [across, down] = [stage.right - stage.left, stage.bottom - stage.top];
    const [wide, high] = [box.right - box.left, box.bottom - box.top];
    expect(box.left).toBeGreaterThanOrEqual(stage.left - 1);
    expect(box.right).toBeLessThanOrEqual(stage.right + 1);
    expect(box.top).toBeGreaterThanOrEqual(stage.top - 1);
    expect(box.bottom).toBeLessThanOrEqual(stage.bottom + 1);
    expect(Math.max(wide / across, high / down)).toBeGreaterThan(0.8);
  }).toPass();
  // The first hole in the dimming layer.
  const [hole, outline] = await page.evaluate(
    (parts) => parts.map((part) => document.querySelector(part)?.getAttribute('points')),
    ['.current .hole polygon', shape],
  );
  expect(hole).toBe(outline);
}

test('an HTML comic is read panel by panel, by pages and as text, and requests nothing', async ({ page }, info) => {
  await openBoard(page);
  await makePageSmall(page);
  await write(page, 'caption', 'Meanwhile <in> Lisbon');
  const { name, bytes } = await savedAs(page, 'html');
  expect(name).toMatch(/\.html$/);
  const path = info.outputPath('comic.html');
  await writeFile(path, bytes);

  const context = page.context();
  const reader = await context.newPage();
  /** @type {string[]} */
  const asked = [];
  reader.on('request', (request) => void asked.push(request.url()));
  reader.on('console', (message) => void asked.push(message.text()));
  reader.on('pageerror', (error) => void asked.push(error.message));
  await reader.emulateMedia({ reducedMotion: 'reduce' });
  const status = reader.getByRole('status');
  for (const width of [360, 1280]) {
    await reader.setViewportSize({ width, height: width === 360 ? 740 : 800 });
    await reader.goto(pathToFileURL(path).href);
    await reader.getByRole('button', { name: 'Panels' }).click();
    const regions = reader.getByRole('region', { name: /^Page 1, panel \d: / });
    const count = await regions.count();
    expect(count).toBeGreaterThan(1);
    for (let panel = 0; panel < count; panel += 1) {
      await expect(status).toContainText(`Page 1, panel ${panel + 1}: `);
      await fills(reader, panel);
      if (panel === 1) await accessible(reader);
      if (panel + 1 < count) await reader.keyboard.press('ArrowRight');
    }
    await expect(reader.getByRole('button', { name: 'Next' })).toHaveAttribute('aria-disabled', 'true');
    // A click on the left side shows the previous panel.
    await reader.mouse.click(20, 200);
    await expect(status).toContainText(`panel ${count - 1}: `);
    await reader.getByRole('button', { name: 'Pages' }).click();
    await accessible(reader);
    await reader.getByRole('button', { name: 'Text' }).click();
    await expect(reader.getByText('Meanwhile <in> Lisbon')).toBeVisible();
    await accessible(reader);
  }
  await reader.emulateMedia({ colorScheme: 'dark' });
  await accessible(reader);
  expect(asked.filter((what) => !what.startsWith('file:') && !what.startsWith('data:'))).toEqual([]);
  // The file without its images is small.
  const text = bytes.toString('utf8').replaceAll(/data:image[^"]*/g, '');
  expect(text.length).toBeLessThan(60_000);
});
