// @ts-check
/** Styles as files and links, and deleted styles. */

import { FOUR, addBlock, button, cards, drawn, names, openDesigner, preview, region } from '../style-designer.js';
import { saved } from '../export-dialog.js';
import { drop, expect, idle, openBoard, picture, tab, sharedBoardTest as test } from '../support.js';

test('a style is exported as a file and a link, and imported from both', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openDesigner(page);
  await addBlock(page, 'Halftone');
  await addBlock(page, 'XDoG', 'Foreground layer');
  await page.getByLabel('Style name').fill('Dots & lines');
  await page.getByLabel('Ink colour').fill('#203050');
  const exported = await saved(page, () => button(page, 'Export style').click());
  expect(exported.name).toBe('dots-lines.json');
  const file = JSON.parse(String(exported.bytes));
  expect(file).toMatchObject({
    name: 'Dots & lines',
    background: [{ block: 'halftone' }],
    foreground: [{ block: 'xdog' }, { block: 'soft_threshold' }],
    ink: '#203050',
  });
  await button(page, 'Copy link').click();
  await expect(page.getByRole('status').getByText('The link was copied to the clipboard.')).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const made = await preview(page);

  const other = await context.newPage();
  await other.goto(link);
  await expect(other.getByText('Dots & lines is in My styles. Add photos to see it.')).toBeVisible();
  expect(new URL(other.url()).hash).toBe('');
  await other.close();

  await region(page).getByRole('combobox', { name: 'Start from' }).selectOption({ label: 'An empty style' });
  await expect(cards(page)).toHaveCount(0);
  await page
    .getByLabel('Style file')
    .setInputFiles({ name: 'dots.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(file)) });
  await expect(cards(page)).toHaveCount(1);
  await expect.poll(() => preview(page)).toBe(made);
  const wrong = { ...file, background: [{ block: 'halftone' }, { block: 'posterize', levels: 900 }] };
  await page
    .getByLabel('Style file')
    .setInputFiles({ name: 'wrong.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(wrong)) });
  await expect(page.getByRole('alert')).toContainText(/wrong\.json.*background\[1\] \(posterize\), levels/);
});

test('a dropped style file opens in the designer, and Undo restores a deleted style', async ({ page }) => {
  await openBoard(page, FOUR);
  const style = {
    id: 'dropped',
    name: 'Dropped',
    tags: ['ink'],
    background: [{ block: 'to_gray' }, { block: 'posterize', levels: 3 }],
  };
  await drop(page, [
    { name: 'dropped.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(style)) },
  ]);
  await drawn(page);
  expect(await names(page)).toEqual(['To GrayScale', 'Posterization']);
  await button(page, 'Use').click();
  await idle(page);
  await tab(page, 'Styles');
  const styles = page.getByRole('listbox', { name: 'Styles' });
  await expect(styles.getByRole('option', { name: 'Dropped' })).toHaveAttribute('aria-selected', 'true');
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  // The page has this style, so it is redrawn.
  const before = await picture(page);
  await cards(page).nth(1).getByRole('slider', { name: 'Levels' }).fill('6');
  await idle(page);
  await expect.poll(() => picture(page)).not.toBe(before);
  await button(page, 'Delete style').click();
  await expect(button(page, 'Delete style')).toBeDisabled();
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(button(page, 'Delete style')).toBeEnabled();
});
