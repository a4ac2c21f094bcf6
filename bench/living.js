// @ts-check
/** Animated panels in the real app: decoded and stylised frames per second, for one panel. */

import { execFileSync } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chooseFormat, openExport } from '../tests/web/app/export-dialog.js';
import { opened } from './opened.js';

/** @typedef {{ style: string, pictures: number, ms: number, width: number, height: number }} Loop */

/** A look of few blocks, one of dots and one of paint. */
const STYLES = ['Adventure Album', 'Manga', 'Oil Painting'];
/** Number of pictures of a loop, and of pictures in the dissolve from its end to its beginning. */
const PICTURES = 36;

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address of the site
 * @param {string} photo background of the moving object
 * @returns {Promise<Loop[]>}
 */
export async function living(browser, address, photo) {
  const film = join(mkdtempSync(join(tmpdir(), 'living-')), 'film.mp4');
  const graph =
    '[0]scale=960:540:force_original_aspect_ratio=increase,crop=960:540,fps=24[a];' +
    'color=orange:s=200x200:r=24:d=4[b];[a][b]overlay=x=60+150*t:y=120+60*t:shortest=1';
  const input = ['-v', 'error', '-loop', '1', '-t', '4', '-i', photo, '-filter_complex', graph];
  execFileSync('ffmpeg', [...input, '-c:v', 'libx264', '-pix_fmt', 'yuv420p', film]);
  const page = await opened(browser, address, [film]);
  /** @type {Loop[]} */
  const loops = [];
  // The first style runs twice, so that loading is not measured.
  for (const style of [STYLES[2], ...STYLES]) {
    await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: style, exact: true }).click();
    await page.waitForFunction(() => document.body.dataset.idle === 'true');
    await chooseFormat(await openExport(page), 'animatic');
    await page.waitForFunction(() => document.querySelector('.animatic canvas')?.hasAttribute('data-shown'));
    const start = Date.now();
    await page.waitForFunction(() => document.querySelector('.animatic canvas')?.hasAttribute('data-moving'));
    const { width, height } = await page.evaluate(() => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('.animatic canvas'));
      return { width: canvas.width, height: canvas.height };
    });
    loops.push({ style, pictures: PICTURES, ms: Date.now() - start, width, height });
    await page.keyboard.press('Escape');
  }
  await page.close();
  return loops.slice(1);
}
