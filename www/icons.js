// @ts-check
/**
 * Draws the icons that the manifest names out of `public/icon.svg`, by Chromium: `node icons.js`. Their PNG files are
 * in git, because they change only with the drawing.
 */

import { readFile, writeFile } from 'node:fs/promises';
import { chromium } from '@playwright/test';

const FOLDER = new URL('./public/', import.meta.url);
/**
 * Scale of the drawing in a maskable icon. Only a circle of four fifths of the side is always visible. The edge of the
 * drawing is empty, so this scale fills the circle.
 */
const SAFE = 0.86;

const svg = await readFile(new URL('icon.svg', FOLDER), 'utf8');
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox'],
});
const page = await browser.newPage();
for (const { file, side, maskable } of [
  { file: 'icon-192.png', side: 192, maskable: false },
  { file: 'icon-512.png', side: 512, maskable: false },
  { file: 'icon-maskable-512.png', side: 512, maskable: true },
]) {
  await page.setViewportSize({ width: side, height: side });
  const drawn = maskable ? side * SAFE : side;
  await page.setContent(`<style>
    body { margin: 0; height: 100vh; display: grid; place-items: center; background: ${maskable ? '#1b1b22' : 'transparent'} }
    svg { width: ${drawn}px; height: ${drawn}px }
  </style>${svg}`);
  await writeFile(new URL(file, FOLDER), await page.screenshot({ omitBackground: !maskable }));
}
await browser.close();
