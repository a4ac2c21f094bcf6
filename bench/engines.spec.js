// @ts-check
/**
 * Times the app in three browser engines, in turns, without GPU acceleration. `cargo xtask bench engines` runs it and writes the
 * table of docs/reports/benchmarks.md.
 */

import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { UNACCELERATED, start } from '../tests/engines/engines.js';
import { personIn } from '../tests/engines/hands.js';
import { test } from '../www/testing.ts';
import { CHOOSING, REST, SHUFFLES, median, watch } from './journey.js';
import { makePhotos } from './photos.js';
import { serve } from './server.js';

const PHOTOS = 12;
const RUNS = 3;
/** Milliseconds between two measurements of the memory. */
const LOOK = 250;
/** Milliseconds without work before the memory is measured again. */
const WHILE = 20_000;
const MB = 2 ** 20;

/** @typedef {{ first: number, read: number, searched: number, shuffle: number, most: number, rested: number }} Times */

const NAMES = Object.keys(UNACCELERATED);
const root = fileURLToPath(new URL('..', import.meta.url));
const folder = join(process.env.INKPANEL_TARGET ?? join(root, 'target'), 'bench');

test('the page in three engines', async ({ browser }) => {
  const photos = await makePhotos(browser, join(root, 'www/public/samples'), join(folder, 'camera'), PHOTOS);
  await browser.close();
  const server = await serve({ site: join(root, 'www/dist') }, { isolated: false });
  /** @type {Record<string, Times[]>} */
  const runs = Object.fromEntries(NAMES.map((name) => [name, []]));
  try {
    for (let run = 0; run < RUNS; run += 1)
      for (const name of NAMES) {
        const times = await measured(name, { address: `${server.address}/site/`, photos });
        runs[name].push(times);
        console.log(name, JSON.stringify(times));
      }
  } finally {
    server.close();
  }
  writeFileSync(join(folder, 'engines.md'), table(runs));
});

/**
 * Measures one visit with twelve photos.
 * @param {string} name of an engine
 * @param {{ address: string, photos: string[] }} of the site, and paths
 * @returns {Promise<Times>} milliseconds and bytes
 */
async function measured(name, { address, photos }) {
  const running = await start(name, UNACCELERATED);
  const memory = watchMemory(running.pid);
  try {
    const { driver } = running;
    const person = await personIn(running, address);
    await person.open({ detects: true });
    await driver.executeScript(`(${watch})()`);
    // Users need at least this time to choose photos, and hover over the button before.
    await driver
      .actions()
      .move({ origin: await person.one('button', /^Choose photos/) })
      .perform();
    await setTimeout(CHOOSING);
    await driver.executeScript('window.watch.afterChoosing().then((times) => { window.told = times; })');
    await person.choose(photos);
    const from = performance.now();
    const until = (/** @type {string} */ what) =>
      driver.wait(() => driver.executeScript(`return ${what}`).catch(() => null), 180_000, what, 100);
    const { drawn, firstPage } = /** @type {any} */ (await until('window.told'));
    await until(`document.body.dataset.searched === 'true' || null`);
    const searched = performance.now() - from - firstPage;
    await person.idle();
    const button = await person.one('button', 'Shuffle');
    const shuffles = [];
    for (let i = 0; i < SHUFFLES; i += 1) {
      await setTimeout(REST);
      shuffles.push(await person.inPage((pressed) => /** @type {any} */ (window).watch.afterPressing(pressed), button));
    }
    const most = memory.most();
    await setTimeout(WHILE);
    return { first: drawn, read: firstPage, searched, shuffle: median(shuffles), most, rested: memory.now() };
  } finally {
    memory.end();
    await running.end();
  }
}

/**
 * Measures the memory of the largest process of a program, without the memory of mapped files.
 * @param {number} pid
 */
function watchMemory(pid) {
  const sizes = () => {
    const all = readdirSync('/proc').filter((name) => /^\d+$/.test(name));
    /** @type {Map<number, { parent: number, bytes: number }>} */
    const known = new Map();
    for (const name of all)
      try {
        const text = readFileSync(`/proc/${name}/status`, 'utf8');
        const of = (/** @type {string} */ what) => Number(new RegExp(`^${what}:\\s+(\\d+)`, 'm').exec(text)?.[1] ?? 0);
        known.set(Number(name), { parent: of('PPid'), bytes: 1024 * (of('RssAnon') + of('RssShmem')) });
      } catch {
        // It has ended meanwhile.
      }
    const below = (/** @type {number} */ id) => {
      for (let at = id; known.has(at); at = known.get(at)?.parent ?? 0) if (at === pid) return true;
      return false;
    };
    return [...known].filter(([id]) => below(id)).map(([, { bytes }]) => bytes);
  };
  let most = 0;
  const now = () => {
    const largest = Math.max(0, ...sizes());
    most = Math.max(most, largest);
    return largest;
  };
  const timer = setInterval(now, LOOK);
  return { now, most: () => most, end: () => clearInterval(timer) };
}

/** Medians, each with its ratio to the value of Chromium. @param {Record<string, Times[]>} runs */
function table(runs) {
  const rows = /** @type {const} */ ([
    ['First page from twelve 12-megapixel JPEG files', 'first', 'ms'],
    ['All twelve files read', 'read', 'ms'],
    ['Face and object detection in all photos, after that', 'searched', 'ms'],
    [`Shuffle to visible page, after ${REST / 1000} s of rest`, 'shuffle', 'ms'],
    ['Peak memory of the largest process', 'most', 'MB'],
    [`Its memory after ${WHILE / 1000} s of rest`, 'rested', 'MB'],
  ]);
  const of = (/** @type {string} */ name, /** @type {keyof Times} */ what) =>
    median(runs[name].map((times) => times[what]));
  const lines = [`| | ${NAMES.map(titled).join(' | ')} |`, `|---|${NAMES.map(() => '--:|').join('')}`];
  for (const [label, what, unit] of rows) {
    const cells = NAMES.map((name) => {
      const value = of(name, what);
      const text = unit === 'MB' ? `${Math.round(value / MB)} MB` : `${Math.round(value)} ms`;
      return name === 'chromium' ? text : `${text} (${(value / of('chromium', what)).toFixed(2)}x)`;
    });
    lines.push(`| ${label} | ${cells.join(' | ')} |`);
  }
  const visits = runs[NAMES[0]].length;
  return [`Each value is the median of ${visits === 1 ? 'one visit' : `${visits} visits`}.`, '', ...lines].join('\n');
}

function titled(/** @type {string} */ name) {
  return { chromium: 'Chromium', firefox: 'Firefox', webkit: 'WebKitGTK' }[name] ?? name;
}
