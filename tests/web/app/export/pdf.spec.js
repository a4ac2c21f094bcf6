// @ts-check
/** PDF files of the page, read by Poppler, and files of several pages. */

import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { promisify } from 'node:util';
import { PNG } from '../../../../www/testing.ts';
import { thumbs } from '../page-strip.js';
import { chooseFormat, openExport, saved, savedAs } from '../export-dialog.js';
import { drop, expect, idle, openBoard, press, tab, sharedBoardTest as test } from '../support.js';
import { write } from '../text-items.js';

const run = promisify(execFile);

test('a PDF file has the page size, searchable text, and the same appearance as the PNG file', async ({
  page,
}, info) => {
  await openBoard(page);
  await write(page, 'caption', 'Meanwhile, at the harbour');
  await write(page, 'balloon', 'Où est le phare?');
  await write(page, 'sound effect', 'KRAKOOM');
  const arc = page.getByRole('spinbutton', { name: 'Arc' });
  await arc.fill('80');
  await arc.blur();
  await idle(page);
  await page.keyboard.press('Escape');
  const { path, name } = await savedAs(page, 'pdf', { quality: 95 });
  expect(name).toMatch(/\.pdf$/);
  const about = (await run('pdfinfo', [path])).stdout;
  expect(about).toMatch(/Pages: +1\n/);
  expect(about).toMatch(/Page size: +595\.2 x 841\.9\d* pts \(A4\)/);
  expect(about).not.toContain('CreationDate');
  const text = (await run('pdftotext', ['-raw', path, '-'])).stdout.replace(/\s+/g, ' ');
  for (const words of ['Meanwhile, at the harbour', 'Où est le phare?']) {
    // Comic lettering is in capitals.
    expect(text.toLowerCase()).toContain(words.toLowerCase());
  }
  expect(text.replace(/ /g, '')).toContain('KRAKOOM');
  const fonts = (await run('pdffonts', [path])).stdout.trim().split('\n').slice(2);
  expect(fonts).toHaveLength(3);
  for (const line of fonts) expect(line).toMatch(/CID TrueType +Identity-H +yes yes yes/);
  await run('pdftoppm', ['-png', '-r', '150', '-singlefile', path, info.outputPath('drawn')]);
  const drawn = PNG.sync.read(await readFile(info.outputPath('drawn.png')));
  const png = await savedAs(page, 'png');
  await writeFile(info.outputPath('page.png'), png.bytes);
  const expected = PNG.sync.read(png.bytes);
  expect([drawn.width, drawn.height]).toEqual([expected.width, expected.height]);
  const { mean, far } = difference(drawn, expected);
  expect(mean).toBeLessThan(4);
  expect(far).toBeLessThan(0.01);
});

/**
 * Compares squares of pixels, because PDF renderers place pixels at fractions.
 * @param {PNG} a
 * @param {PNG} b
 * @returns {{ mean: number, far: number }} the mean difference of the channels, of 255, and the share of the squares with a large difference
 */
function difference(a, b) {
  const side = 10;
  let [sum, count, far] = [0, 0, 0];
  for (let y = 0; y + side <= a.height; y += side) {
    for (let x = 0; x + side <= a.width; x += side) {
      for (let channel = 0; channel < 3; channel += 1) {
        let off = 0;
        for (let i = 0; i < side * side; i += 1) {
          const at = ((y + Math.floor(i / side)) * a.width + x + (i % side)) * 4 + channel;
          off += a.data[at] - b.data[at];
        }
        const mean = Math.abs(off) / side ** 2;
        sum += mean;
        count += 1;
        if (mean > 30) far += 1;
      }
    }
  }
  return { mean: sum / count, far: far / count };
}

test('all pages are saved in one PDF file, and in one comic archive, which can be opened again', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('3');
  await idle(page);
  await press(page, 'Add page');
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'pdf');
  await expect(dialog.getByRole('radio', { name: 'All 2 pages' }), 'the first choice').toBeChecked();
  await expect(dialog.getByRole('radio', { name: 'Square' })).toHaveCount(0);
  await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
  const pdf = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  expect(pdf.name).toMatch(/\d{4}\.pdf$/);
  expect((await run('pdfinfo', [pdf.path])).stdout).toMatch(/Pages: +2\n/);
  expect((await run('pdfimages', ['-list', pdf.path])).stdout.match(/ jpeg /g)?.length).toBe(6);
  await openExport(page);
  await expect(dialog.getByRole('radio', { name: 'PDF', exact: true }), 'the last format').toBeChecked();
  await dialog.getByRole('radio', { name: 'This page' }).check();
  await chooseFormat(dialog, 'cbz');
  await expect(dialog.getByRole('radio', { name: 'All 2 pages' }), 'each kind has its choice').toBeChecked();
  await chooseFormat(dialog, 'pdf');
  await expect(dialog.getByRole('radio', { name: 'This page' }), 'the last choice').toBeChecked();
  await chooseFormat(dialog, 'cbz');
  await dialog.getByRole('radio', { name: 'This page' }).check();
  await dialog.getByRole('radio', { name: 'All 2 pages' }).check();
  await expect(dialog.getByRole('radio', { name: 'CBZ' }), 'the format survives').toBeChecked();
  await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
  await dialog.getByRole('radio', { name: 'Editing again on this device' }).check();
  await dialog.getByRole('combobox', { name: 'Embedded images' }).selectOption('jpeg');
  const cbz = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  expect(cbz.name).toMatch(/\d{4}\.cbz$/);
  const names = new Set(cbz.bytes.toString('latin1').match(/page-\d\d\.jpg|ComicInfo\.xml|comic\.acbf/g));
  expect([...names]).toEqual(['page-01.jpg', 'page-02.jpg', 'ComicInfo.xml', 'comic.acbf']);
  // The archive contains the project with all pages.
  await drop(page, [{ name: cbz.name, mimeType: 'application/vnd.comicbook+zip', buffer: cbz.bytes }]);
  await expect(page.getByRole('status').getByText(`${cbz.name} was opened as a separate project`)).toBeVisible();
  await idle(page);
  await expect(thumbs(page)).toHaveCount(2);
});
