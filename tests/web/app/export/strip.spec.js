// @ts-check
/** Vertical strips for webtoon readers. */

import { chooseFormat, openExport, saved } from '../export-dialog.js';
import { boardTest as test, expect } from '../support.js';

/** Sizes of the JPEG files in an archive without compression. @param {Buffer} archive */
function sizesIn(archive) {
  const sizes = [];
  for (let at = archive.indexOf('PK\x03\x04', 0, 'latin1'); at >= 0; ) {
    const start = at + 30 + archive.readUInt16LE(at + 26) + archive.readUInt16LE(at + 28);
    // A baseline frame: marker, length, precision, height, width.
    const frame = archive.indexOf(Buffer.from([0xff, 0xc0]), start);
    sizes.push([archive.readUInt16BE(frame + 7), archive.readUInt16BE(frame + 5)]);
    at = archive.indexOf('PK\x03\x04', start, 'latin1');
  }
  return sizes;
}

test('the panels below each other are pictures of at most 800 x 1280 pixels', async ({ page }) => {
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'strip');
  await expect(dialog.getByText('800 x 1,280 pixels')).toBeVisible();
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  expect(file.name).toMatch(/\.zip$/);
  const sizes = sizesIn(file.bytes);
  expect(sizes.length).toBeGreaterThan(2);
  for (const [width, height] of sizes) {
    expect(width).toBe(800);
    expect(height).toBeLessThanOrEqual(1280);
  }
});
