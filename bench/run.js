// @ts-check
/**
 * The benchmark: `cargo xtask bench` starts it with the folders it needs. Times every block and the same
 * operations by other libraries in one browser session, then the real page; writes JSON and docs/reports/benchmarks.md.
 */

import { readFileSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { CHROMIUM } from '../tests/web/launching.js';
import { animatic } from './animatic.js';
import { living } from './living.js';
import { crowd } from './crowd.js';
import { makeFilm } from './footage.js';
import { journey } from './journey.js';
import { making } from './making.js';
import { masking } from './masking.js';
import { makePhotos } from './photos.js';
import { highlights, insert, markdown } from './report.js';
import { rows as allRows } from './rows.js';
import { serve } from './server.js';

const PEERS = {
  opencv: '@techstark/opencv-js',
  canvas: null,
  vips: 'wasm-vips',
  photon: '@silvia-odwyer/photon',
};

/** Number of photos of an afternoon and of a holiday. */
const [FEW, MANY] = [12, 300];
/** Duration of a film in minutes. */
const MINUTES = 30;

const { values: options, positionals: filter } = parseArgs({
  allowPositionals: true,
  options: {
    root: { type: 'string', default: fileURLToPath(new URL('..', import.meta.url)) },
    target: { type: 'string', default: fileURLToPath(new URL('../target', import.meta.url)) },
    alone: { type: 'boolean', default: false },
  },
});

const here = fileURLToPath(new URL('.', import.meta.url));
const album = join(options.root, 'www/public/samples');
/** Pages in three styles, as pictures for the style search. */
const PICTURES = ['noir', 'comic', 'screenprint'].map((name) => join(options.root, `docs/pages/${name}.png`));
/** Parts that broke down. @type {string[]} */
const broken = [];
const started = performance.now();
const [load] = loadavg();
const browser = await chromium.launch(CHROMIUM);
try {
  const results = await blocks();
  const whole = filter.length === 0;
  await part('page', 'the page', async () => {
    const files = await photos(FEW);
    results.journey = await site((address) => journey(browser, address, files));
  });
  await part('album', 'an album', async () => {
    const files = await photos(MANY);
    results.crowd = await site((address) => crowd(browser, address, files));
  });
  await part('films', 'films', async () => {
    const film = makeFilm(album, join(options.target, 'bench/films'), MINUTES);
    const read = await site((address) => crowd(browser, address, [film]));
    results.footage = [{ minutes: MINUTES, ...read }];
  });
  await part('making', 'styles in the making', async () => {
    const files = await photos(FEW);
    results.making = await site((address) => making(browser, address, files.slice(0, 4), PICTURES));
  });
  await part('masking', 'the page while masks are made', async () => {
    const files = await photos(FEW);
    results.masking = await site((address) => masking(browser, address, files));
  });
  await part('animatic', 'animatics', async () => {
    const files = await photos(FEW);
    results.films = await site((address) => animatic(browser, address, files));
  });
  await part('living', 'panels that move', async () => {
    const [photo] = await photos(FEW);
    results.loops = await site((address) => living(browser, address, photo));
  });
  const table = markdown(results);
  console.log(`\n${table}`);
  if (whole && !options.alone) {
    writeFileSync(join(options.target, 'bench.json'), `${JSON.stringify(results, null, 2)}\n`);
    // A table with gaps would lose earlier values.
    if (broken.length === 0) {
      insert(join(options.root, 'docs/reports/benchmarks.md'), table);
      insert(join(options.root, 'README.md'), highlights(results));
    }
    console.log(`in ${Math.round((performance.now() - started) / 60_000)} minutes`);
  }
} finally {
  await browser.close();
}
if (broken.length > 0) {
  console.error(`not measured: ${broken.join(', ')}`);
  process.exitCode = 1;
}

/**
 * Times one part in addition to the rows, if it is requested. If it fails, only its values are missing.
 * @param {string} name of the part on the command line
 * @param {string} what label of its duration
 * @param {() => Promise<void>} time
 */
async function part(name, what, time) {
  if (!asked(name)) return;
  const begin = performance.now();
  try {
    await time();
  } catch (error) {
    console.error(error);
    broken.push(name);
  }
  report(what, begin);
}

/**
 * Prints the duration of a part, because the whole benchmark has a goal of 15 minutes.
 * @param {string} what
 * @param {number} begin
 */
function report(what, begin) {
  console.log(`${((performance.now() - begin) / 60_000).toFixed(1)} min  ${what}`);
}

/** The first of the photos that the page is timed with. @param {number} count */
function photos(count) {
  return makePhotos(browser, album, join(options.target, 'bench/camera'), count);
}

/** Whether an additional part is measured: always without a filter, otherwise by its name. @param {string} part */
function asked(part) {
  return filter.length === 0 || filter.includes(part);
}

/** @returns {Promise<import('./report.js').Results>} */
async function blocks() {
  const www = join(options.root, 'www');
  const folders = {
    page: join(here, 'page'),
    modules: join(here, 'node_modules'),
    album,
    pkg: join(options.target, 'bench/pkg'),
    detector: join(www, 'pkg-detector'),
    models: join(www, 'models'),
  };
  const { address, close } = await serve(folders, { isolated: true });
  const page = await browser.newPage();
  await page.goto(`${address}/page/index.html`);
  const begin = performance.now();
  const { blocks, styles } = await page.evaluate(async () => {
    const { catalogue } = await import(/** @type {any} */ ('/page/contestants/inkpanel.js'));
    return catalogue();
  });
  const rows = allRows(blocks, styles).filter(({ id }) => !filter.length || filter.some((word) => id.includes(word)));
  /** @type {import('./report.js').Results} */
  const results = {
    machine: {
      cores: cpus().length,
      cpu: cpus()[0].model.trim(),
      load,
      browser: `Chromium ${browser.version()}`,
      copySpeed: await page.evaluate(() => /** @type {any} */ (globalThis).bench.copySpeed()),
    },
    rows,
    times: {},
    failed: {},
    versions: {},
    journey: null,
    crowd: null,
    footage: null,
    making: null,
    masking: null,
    films: null,
    loops: null,
    detect: !asked('detect') ? null : await page.evaluate(() => /** @type {any} */ (globalThis).bench.detect()),
    aesthetics: !asked('detect') ? null : await page.evaluate(() => /** @type {any} */ (globalThis).bench.aesthetics()),
    figures: !asked('figures') ? null : await page.evaluate(() => /** @type {any} */ (globalThis).bench.figures()),
    facts: !asked('facts')
      ? null
      : await page.evaluate(
          (photo) => /** @type {any} */ (globalThis).bench.facts(photo),
          `${address}/album/06-castle.jpg`,
        ),
    plans: !asked('plans') ? null : await page.evaluate(() => /** @type {any} */ (globalThis).bench.plans()),
    masks: !asked('masks') ? null : await page.evaluate(() => /** @type {any} */ (globalThis).bench.masks()),
  };
  report('detectors, figures, plans and masks', begin);
  for (const name of ['inkpanel', ...(options.alone ? [] : Object.keys(PEERS))]) {
    const begin = performance.now();
    const ask = /** @type {const} */ ([name, rows, `${address}/album/06-castle.jpg`]);
    const timed = page.evaluate((a) => /** @type {any} */ (globalThis).bench.times(...a), ask);
    // A peer that does not load or breaks down leaves an empty column, not an empty table.
    const times = await timed.catch((/** @type {Error} */ error) => {
      if (name === 'inkpanel') throw error;
      results.failed[name] = error.message.split('\n')[0];
    });
    if (times) results.times[name] = times;
    results.versions[name] = version(PEERS[name]);
    report(`blocks by ${name}`, begin);
  }
  await page.close();
  close();
  return results;
}

/**
 * The real site, as any host would serve it.
 * @template T
 * @param {(address: string) => Promise<T>} use
 */
async function site(use) {
  const { address, close } = await serve({ site: join(options.root, 'www/dist') }, { isolated: false });
  try {
    return await use(`${address}/site/`);
  } finally {
    close();
  }
}

/** @param {string | null | undefined} name of an installed package */
function version(name) {
  if (!name) return '';
  return JSON.parse(readFileSync(join(here, 'node_modules', name, 'package.json'), 'utf8')).version;
}
