// @ts-check
/**
 * The speed of the first page and of Shuffle, as ratios that hold on a busy machine: `node bench/speed.js`.
 * With `--against FOLDER` it measures another build of the site in turns with this one.
 *
 * With `--history FILE` it appends the medians of this build to a file, and compares them with the last entry of the same
 * processor.
 *
 * Milliseconds depend on the load of the machine. So the first page is divided by the time in which the browser decodes
 * the same files in the same round, and CPU time is printed as well.
 */

import { execFileSync } from 'node:child_process';
import { appendFileSync, existsSync, readFileSync, readdirSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { CHROMIUM } from '../tests/web/launching.js';
import { browserDecodes, hurried, median, opened, shuffled } from './journey.js';
import { makePhotos } from './photos.js';
import { serve } from './server.js';

/** @typedef {import('playwright-core').Browser} Browser */
/** @typedef {import('playwright-core').Page} Page */
/**
 * @typedef {{
 *   load: number, decoded: number, sketched: number, drawn: number, ratio: number, firstMain: number, firstAll: number, longest: number,
 *   hurried: number, shuffle: number, shuffleMain: number, shuffleAll: number, rested: number, restedMain: number,
 * }} Speed Times are milliseconds. `ratio` is the time of the first page divided by `decoded`. `Main` is the CPU time of the
 *   main thread, and `All` the CPU time of the tab. `longest` is the longest task until all photos are read.
 */

const PHOTOS = 12;
const SHUFFLES = 12;
const RESTS = 8;
/** Milliseconds of rest before a shuffle. */
const REST = 600;
/** Milliseconds per clock tick of `/proc`. */
const TICK = 10;

/**
 * One visit: the first page, shuffles in the first ten seconds, shuffles without and with rest.
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<Speed>}
 */
export async function speed(browser, address, photos) {
  const decoded = await browserDecodes(browser, photos);
  const [load] = loadavg();
  const { page, drawn, sketched, before } = await opened(browser, address, photos, {
    before: async (page) => {
      await page.evaluate(() => {
        const tasks = /** @type {number[]} */ ([]);
        Object.assign(globalThis, { tasks });
        new PerformanceObserver((list) => tasks.push(...list.getEntries().map(({ duration }) => duration))).observe({
          entryTypes: ['longtask'],
        });
      });
      return cpu(browser);
    },
  });
  const first = since(before, await cpu(browser));
  const longest = await page.evaluate(() => Math.max(0, .../** @type {any} */ (globalThis).tasks));
  const { ms } = await hurried(page);
  await page.waitForFunction(() => document.body.dataset.detected === 'true', null, { timeout: 300_000, polling: 100 });
  const fast = await timed(browser, page, SHUFFLES, 0);
  const slow = await timed(browser, page, RESTS, REST);
  await page.close();
  return {
    load,
    decoded,
    sketched,
    drawn,
    ratio: drawn / decoded,
    firstMain: first.main,
    firstAll: first.all,
    longest,
    hurried: ms,
    shuffle: fast.ms,
    shuffleMain: fast.main,
    shuffleAll: fast.all,
    rested: slow.ms,
    restedMain: slow.main,
  };
}

/**
 * @param {Browser} browser
 * @param {Page} page
 * @param {number} count of shuffles
 * @param {number} rest milliseconds before each
 */
async function timed(browser, page, count, rest) {
  const times = [];
  const before = await cpu(browser);
  for (let i = 0; i < count; i += 1) {
    if (rest > 0) await page.waitForTimeout(rest);
    times.push(await shuffled(page));
  }
  const { main, all } = since(before, await cpu(browser));
  return { ms: median(times), main: main / count, all: all / count };
}

/**
 * CPU times of the tab's process in milliseconds. Zero on systems other than Linux.
 * @param {Browser} browser
 */
async function cpu(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const tabs = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => processTimes(id));
  // The other processes are idle pages, which the browser prepares.
  return tabs.sort((a, b) => b.all - a.all)[0] ?? { main: 0, all: 0 };
}

/** @param {number} id of a process */
function processTimes(id) {
  try {
    const threads = readdirSync(`/proc/${id}/task`).map((thread) => {
      const fields = readFileSync(`/proc/${id}/task/${thread}/stat`, 'utf8').replace(/^.*\)/, '').split(' ');
      return { thread: Number(thread), ms: TICK * (Number(fields[12]) + Number(fields[13])) };
    });
    const [whole] = [readFileSync(`/proc/${id}/stat`, 'utf8').replace(/^.*\)/, '').split(' ')];
    // Ended threads are included in the time of the process.
    const all = TICK * (Number(whole[12]) + Number(whole[13]));
    return { main: threads.find(({ thread }) => thread === id)?.ms ?? 0, all };
  } catch {
    return { main: 0, all: 0 };
  }
}

/** @param {{ main: number, all: number }} before @param {{ main: number, all: number }} after */
function since(before, after) {
  return { main: after.main - before.main, all: after.all - before.all };
}

/** Values that hold on a busy machine, and the increase that counts as a regression. */
const WATCHED = /** @type {const} */ (['ratio', 'firstMain', 'firstAll', 'shuffleMain', 'restedMain']);
const REGRESSION = 1.25;

/**
 * @param {Speed[]} rounds
 * @returns {Speed}
 */
function medians(rounds) {
  const names = /** @type {(keyof Speed)[]} */ (Object.keys(rounds[0]));
  const entries = names.map((name) => [name, Number(median(rounds.map((round) => round[name])).toFixed(2))]);
  return /** @type {Speed} */ (Object.fromEntries(entries));
}

/**
 * Appends an entry to the history, one JSON object per line, and prints values that are worse than in the last entry.
 * @param {string} file
 * @param {Speed} speed
 * @param {string} root folder of the repository
 */
function remember(file, speed, root) {
  const machine = { cpu: cpus()[0].model.trim(), cores: cpus().length };
  const lines = existsSync(file) ? readFileSync(file, 'utf8').trim().split('\n') : [];
  const before = lines
    .filter((line) => line !== '')
    .map((line) => JSON.parse(line))
    .findLast(({ cpu, cores }) => cpu === machine.cpu && cores === machine.cores);
  for (const name of before ? WATCHED : [])
    if (speed[name] > REGRESSION * before[name]) console.log(`slower: ${name} ${before[name]} -> ${speed[name]}`);
  const commit = execFileSync('git', ['rev-parse', '--short', 'HEAD'], { cwd: root, encoding: 'utf8' }).trim();
  const date = new Date().toISOString().slice(0, 10);
  appendFileSync(file, `${JSON.stringify({ date, commit, ...machine, ...speed })}\n`);
}

/** Prints the medians of each site, and the ratio of the first site to the second. @param {Speed[][]} sites */
export function summary(sites) {
  const names = /** @type {(keyof Speed)[]} */ (Object.keys(sites[0][0]));
  for (const name of names) {
    const values = sites.map((rounds) => median(rounds.map((round) => round[name])));
    const [own, other] = values;
    const text = values.map((value) => value.toFixed(value < 20 ? 2 : 0)).join(' against ');
    // The ratio of two rounds that ran under the same load.
    const ratios = sites[1] && median(sites[0].map((round, i) => round[name] / sites[1][i][name]));
    const compared = other === undefined ? '' : `  (${(own / other).toFixed(2)}x, in pairs ${ratios.toFixed(2)}x)`;
    console.log(`${name.padEnd(12)} ${text}${compared}`);
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const root = fileURLToPath(new URL('..', import.meta.url));
  const { values: options } = parseArgs({
    options: {
      site: { type: 'string', default: join(root, 'www/dist') },
      against: { type: 'string' },
      history: { type: 'string' },
      target: { type: 'string', default: join(root, 'target') },
      rounds: { type: 'string', default: '3' },
    },
  });
  const browser = await chromium.launch(CHROMIUM);
  try {
    const photos = await makePhotos(
      browser,
      join(root, 'www/public/samples'),
      join(options.target, 'bench/camera'),
      PHOTOS,
    );
    const folders = [options.site, options.against].flatMap((folder) => folder ?? []);
    const servers = await Promise.all(folders.map((site) => serve({ site }, { isolated: false })));
    /** @type {Speed[][]} */
    const rounds = folders.map(() => []);
    for (let round = 0; round < Number(options.rounds); round += 1)
      for (const [i, { address }] of servers.entries()) {
        const times = await speed(browser, `${address}/site/`, photos);
        rounds[i].push(times);
        console.log(folders[i], JSON.stringify(times));
      }
    summary(rounds);
    if (options.history) remember(options.history, medians(rounds[0]), root);
    for (const server of servers) server.close();
  } finally {
    await browser.close();
  }
}
