// @ts-check
/** The browsers of the tests. Each starts with an empty profile and a download folder, and WebDriver controls it. */

import { spawn } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { Builder } from '../../www/testing.ts';
import { CHROMIUM } from '../web/launching.js';

/** @typedef {import('../../www/testing.ts').WebDriver} WebDriver */
/** A browser that runs; `pid` of the program that drives it. @typedef {{ driver: WebDriver, downloads: string, pid: number, end: () => Promise<void> }} Running */
/**
 * Settings of a WebDriver program. @typedef {{ program: string, capabilities: (folders: Folders) => object, screen?:
 * boolean }} Engine
 */
/** Both are empty, and removed afterwards. @typedef {{ downloads: string, data: string }} Folders */

const WINDOW = fileURLToPath(new URL('./window.py', import.meta.url));
const GECKODRIVER = process.env.GECKODRIVER ?? 'geckodriver';

/** @type {Record<string, Engine>} */
export const ENGINES = {
  chromium: {
    program: process.env.CHROMEDRIVER ?? 'chromedriver',
    capabilities: ({ downloads, data }) => ({
      browserName: 'chrome',
      'goog:chromeOptions': {
        binary: CHROMIUM.executablePath,
        args: ['--headless', ...CHROMIUM.args, '--window-size=1280,800', `--user-data-dir=${data}`],
        prefs: { 'download.default_directory': downloads },
      },
    }),
  },
  firefox: firefox({}),
  'firefox-private': firefox({ 'browser.privatebrowsing.autostart': true }),
  webkit: webkit(({ downloads, data }) => [downloads, data]),
  'webkit-private': webkit(({ downloads }) => [downloads]),
};

/**
 * Without emulation of a graphics card. Chromium always runs like this here. WebKit spends a third of its time on the
 * emulation.
 */
export const UNACCELERATED = {
  chromium: ENGINES.chromium,
  firefox: ENGINES.firefox,
  webkit: webkit(({ downloads, data }) => ['--unaccelerated', downloads, data]),
};

/** @param {Record<string, unknown>} prefs in addition to the preferences of every test @returns {Engine} */
function firefox(prefs) {
  return {
    program: GECKODRIVER,
    capabilities: ({ downloads }) => ({
      browserName: 'firefox',
      'moz:firefoxOptions': {
        binary: process.env.FIREFOX ?? '/usr/bin/firefox-esr',
        args: ['-headless', '--width=1280', '--height=800'],
        prefs: {
          'browser.download.folderList': 2,
          'browser.download.dir': downloads,
          'browser.download.always_ask_before_handling_new_types': false,
          'browser.helperApps.neverAsk.saveToDisk':
            'image/png,image/jpeg,image/webp,application/pdf,application/zip,application/octet-stream',
          'pdfjs.disabled': true,
          'app.update.enabled': false,
          'network.captive-portal-service.enabled': false,
          'network.connectivity-service.enabled': false,
          ...prefs,
        },
      },
    }),
  };
}

/** @param {(folders: Folders) => string[]} args of `window.py` @returns {Engine} */
function webkit(args) {
  return {
    program: process.env.WEBKIT_DRIVER ?? 'WebKitWebDriver',
    screen: true,
    capabilities: (folders) => ({
      browserName: 'window.py',
      'webkitgtk:browserOptions': { binary: WINDOW, args: args(folders) },
    }),
  };
}

/** Maximum milliseconds for starting a browser, and number of attempts. */
const PATIENCE = 30_000;
const TRIES = 2;

/**
 * Starts a browser with an empty profile.
 * @param {string} name
 * @param {Record<string, Engine>} [engines] must contain an engine of this name
 * @returns {Promise<Running>}
 */
export async function start(name, engines = ENGINES) {
  for (let left = TRIES - 1; ; left -= 1) {
    try {
      return await startOnce(name, engines[name]);
    } catch (error) {
      if (left === 0) throw error;
    }
  }
}

/** @param {string} name @param {Engine} engine @returns {Promise<Running>} */
async function startOnce(name, { program, capabilities, screen }) {
  const root = await mkdtemp(join(tmpdir(), 'inkpanel-engine-'));
  const [downloads, data] = await Promise.all(['downloads-', 'data-'].map((kind) => mkdtemp(join(root, kind))));
  /** @type {(() => Promise<unknown>)[]} cleanup functions, in reverse order */
  const endings = [() => rm(root, { recursive: true, force: true, maxRetries: 5 })];
  const end = async () => {
    // A browser that hangs does not answer a quit command. Then its driver and all child processes are terminated.
    for (const ending of endings.reverse()) await inTime(ending(), PATIENCE, 'it does not end').catch(() => {});
  };
  try {
    const display = screen ? await startScreen(endings) : undefined;
    const port = await freePort();
    const env = { ...process.env, ...(display && { DISPLAY: display, GDK_BACKEND: 'x11', NO_AT_BRIDGE: '1' }) };
    const child = spawn(program, [`--port=${port}`], { env, stdio: 'ignore', detached: true });
    endings.push(stopper(child));
    const url = `http://127.0.0.1:${port}`;
    await answers(`${url}/status`, program);
    const builder = new Builder().usingServer(url).withCapabilities(capabilities({ downloads, data }));
    const driver = await inTime(Promise.resolve(builder.build()), PATIENCE, `${name} does not start`);
    endings.push(() => driver.quit());
    return { driver, downloads, pid: Number(child.pid), end };
  } catch (error) {
    await end();
    throw error;
  }
}

/**
 * Returns the result of `work`, or an error after a time limit. WebDriver has no time limit for a browser that hangs.
 * @template T
 * @param {Promise<T>} work
 * @param {number} limit milliseconds
 * @param {string} fault
 * @returns {Promise<T>}
 */
export function inTime(work, limit, fault) {
  const late = setTimeout(limit, undefined, { ref: false }).then(() => {
    throw new Error(fault);
  });
  // The error of the slower promise is ignored.
  for (const promise of [work, late]) promise.catch(() => {});
  return Promise.race([work, late]);
}

/**
 * Starts an invisible screen, because WebKit has no headless mode.
 * @param {(() => Promise<unknown>)[]} endings
 * @returns {Promise<string>} its name
 */
async function startScreen(endings) {
  const screen = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
    detached: true,
  });
  endings.push(stopper(screen));
  const told = /** @type {import('node:stream').Readable} */ (screen.stdio[3]);
  // It writes the number and the line end separately, and terminates if the second write has no reader.
  for await (const number of createInterface({ input: told })) return `:${number}`;
  throw new Error('Xvfb does not start');
}

/** @param {import('node:child_process').ChildProcess} child leader of a process group, which is terminated with it */
function stopper(child) {
  const gone = new Promise((resolve) => child.once('exit', resolve).once('error', resolve));
  return async () => {
    if (child.pid && child.exitCode === null) process.kill(-child.pid);
    await gone;
  };
}

/** @returns {Promise<number>} */
async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const about = server.address();
  await new Promise((resolve) => server.close(resolve));
  return typeof about === 'object' && about ? about.port : 0;
}

/** Waits until a program listens. @param {string} url @param {string} program */
async function answers(url, program) {
  for (let i = 0; i < 200; i += 1) {
    if (await fetch(url).catch(() => null)) return;
    await setTimeout(100);
  }
  throw new Error(`${program} does not answer`);
}
