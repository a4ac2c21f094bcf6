// @ts-check
/** The net of subjects in the browser, whose convolutions are its own, against ONNX Runtime: `tests/segment.rs` says the same natively. */

import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { expect, test } from '../../../www/testing.ts';
import { openCore } from './core.js';

/** The object that `openCore` stored in the page. @type {any} */
let core;

const ROOT = new URL('../../../', import.meta.url);
/** Side of the model's output, and number of sampled positions per side in the oracle. */
const [SIDE, ACROSS] = [320, 40];

test('subjects are those of ONNX Runtime', async ({ page }) => {
  test.skip(!existsSync(new URL('www/models/subject.onnx', ROOT)), 'there is no net of subjects');
  const { subjects } = JSON.parse(await readFile(new URL('tests/oracles/data/segment.json', ROOT), 'utf8'));
  await openCore(page);
  for (const { file, shares } of subjects.slice(0, 4)) {
    const photo = (await readFile(new URL(file, ROOT))).toString('base64');
    const share = read(await page.evaluate(found, photo));
    const apart = [...Buffer.from(shares, 'hex')].map((expected, i) => {
      const place = (/** @type {number} */ at) => (4.5 + 8 * at) / SIDE;
      return Math.abs(share(place(i % ACROSS), place(Math.floor(i / ACROSS))) - expected / 255);
    });
    // A mask has the shape of its photo and sixteen steps, which make up most of it.
    expect.soft(apart.reduce((sum, one) => sum + one) / apart.length, file).toBeLessThan(0.01);
  }
});

/**
 * Runs in the page.
 * @param {string} photo a file in base64
 * @returns {Promise<string>} its mask
 */
async function found(photo) {
  const nets = await import(/** @type {any} */ ('/pkg-detector/inkpanel.js'));
  const [net, studio] = [await fetch('/models/subject.onnx'), new core.Studio(), await nets.default()];
  const bytes = Uint8Array.from(atob(photo), (letter) => letter.charCodeAt(0));
  const { work } = JSON.parse(studio.import_photo('a', bytes));
  const subjects = new nets.SubjectNet(new Uint8Array(await net.arrayBuffer()));
  const look = subjects.begin(work.width, work.height, studio.photo_planes('a/work'));
  for (;;) {
    const mask = look.advance();
    if (mask !== undefined) return mask;
  }
}

/**
 * @param {string} mask a letter a pixel, from none to all, and how often it comes
 * @returns {(x: number, y: number) => number} the share at a place in fractions of the photo
 */
function read(mask) {
  const [size, text] = mask.split(':');
  const [width, height] = size.split('x').map(Number);
  const shares = [...text.matchAll(/([a-p])(\d*)/g)].flatMap(([, letter, count]) =>
    Array(Number(count || 1)).fill((letter.charCodeAt(0) - 97) / 15),
  );
  return (x, y) => shares[Math.floor(y * height) * width + Math.floor(x * width)];
}
