// @ts-check
/** User actions and observations: controls by role and accessible name, uploaded and downloaded files. */

import { readFile, readdir, stat, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Key, Origin, PNG, QUERIES, expect, test as plain } from '../../www/testing.ts';
import { WAYS } from '../web/app/export-dialog.js';
import { inTime, start } from './engines.js';

/** @typedef {import('../../www/testing.ts').WebElement} WebElement */
/** @typedef {import('./engines.js').Running} Running */
/** @typedef {string | RegExp} Name */
/** The first with that role and name. @typedef {[role: string, name: Name]} Place */
/** @typedef {Awaited<ReturnType<typeof personIn>>} Person */

const TESTS = new URL('../', import.meta.url);

/** A file of the tests' own. @param {string} path */
export const given = (path) => fileURLToPath(new URL(path, TESTS));

/** @param {...string} names */
export const photos = (...names) => names.map((name) => given(`photos/${name}`));

/** Six photos: a page, and quick to read. */
export const SIX = photos('bee.jpg', 'cat.jpg', 'crab.jpg', 'gateway.jpg', 'macaw.jpg', 'temple.jpg');

/** Long, as a busy machine may be slow; a test has its own limit. */
const PATIENCE = 90_000;

/**
 * A test with a user at a browser. It fails if the page throws or logs an error.
 * @type {import('../../www/testing.ts').TestWith<{ person: Person }>}
 */
export const test = plain.extend(
  /** @type {any} */ ({
    person: async (
      /** @type {{ baseURL: string }} */ { baseURL },
      /** @type {(person: Person) => Promise<void>} */ use,
      /** @type {import('../../www/testing.ts').TestInfo} */ info,
    ) => {
      const running = await start(String(info.project.metadata.engine));
      const person = await personIn(running, baseURL);
      try {
        await use(person);
        expect(await person.faults()).toEqual([]);
      } finally {
        // The test runner records the result, because `use` does not throw it.
        if (info.status !== info.expectedStatus) {
          const seen = await running.driver.takeScreenshot().catch(() => '');
          await writeFile(info.outputPath('seen.png'), seen, 'base64');
        }
        await running.end();
      }
    },
  }),
);

export { PNG, expect, plain };

/** @param {string} url data URL of a picture, from a canvas */
const decoded = (url) => PNG.sync.read(Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));

/**
 * Waits until a picture equals the expected one. A failure reports the difference, and stores both pictures and their
 * difference.
 * @param {() => Promise<string>} picture
 * @param {string} expected
 */
export async function becomes(picture, expected) {
  let actual = '';
  const same = async () => (actual = await picture()) === expected;
  try {
    await expect.poll(same).toBe(true);
  } catch {
    const [before, after] = [decoded(expected), decoded(actual)];
    const difference = new PNG({ width: before.width, height: before.height });
    let [far, pixels] = [0, 0];
    if (before.data.length === after.data.length)
      for (let i = 0; i < before.data.length; i += 1) {
        const off = Math.abs(before.data[i] - after.data[i]);
        if (off > 0 && i % 4 < 3) pixels += 1;
        far = Math.max(far, off);
        difference.data[i] = i % 4 === 3 ? 255 : Math.min(255, 16 * off);
      }
    for (const [name, png] of Object.entries({ expected: before, actual: after, difference }))
      await writeFile(plain.info().outputPath(`${name}.png`), PNG.sync.write(png));
    throw new Error(
      `the picture of ${after.width} by ${after.height} is not the one of ${before.width} by ${before.height} ` +
        `that it was: ${pixels} samples differ, by ${far} of 255 at most`,
    );
  }
}

/**
 * Runs in the page, next to the library that it uses.
 * @param {string} role
 * @param {any} name
 * @param {[role: string, name: any] | null} within
 * @returns {Element[]}
 */
function perceived(role, name, within) {
  const library = /** @type {any} */ (globalThis).TestingLibraryDom;
  const find = (/** @type {Element} */ place, /** @type {string} */ role, /** @type {any} */ name) => {
    const pattern = name?.source ? new RegExp(name.source, name.flags) : name;
    const found = library.queryAllByRole(place, role, pattern === null ? {} : { name: pattern });
    return found.filter((/** @type {Element} */ element) => element.checkVisibility());
  };
  const place = within ? find(document.body, ...within)[0] : document.body;
  return place ? find(place, role, name) : [];
}

/**
 * @param {Running} running
 * @param {string} address of the page
 */
export async function personIn({ driver, downloads }, address) {
  await driver.manage().setTimeouts({ script: PATIENCE, pageLoad: PATIENCE });

  /**
   * Runs a function in the page.
   * @template {any[]} Given @template Result
   * @param {(...given: Given) => Result | Promise<Result>} what
   * @param {Given} values
   * @returns {Promise<Result>}
   */
  const inPage = (what, ...values) =>
    driver
      .executeAsyncScript(
        `const done = arguments[arguments.length - 1];
       Promise.resolve((${what}).apply(null, [].slice.call(arguments, 0, -1))).then((value) => done({ value }), (error) => done({ error: String(error) }));`,
        ...values,
      )
      .then((/** @type {any} */ { value, error }) => {
        if (error) throw new Error(error);
        return value;
      });

  /**
   * All that can be perceived with a role and a name.
   * @param {string} role
   * @param {Name} [name] complete, or a pattern
   * @param {Place} [within]
   * @returns {Promise<WebElement[]>}
   */
  async function all(role, name, within) {
    const plain = (/** @type {Name | undefined} */ one) =>
      one instanceof RegExp ? { source: one.source, flags: one.flags } : one;
    const look = () =>
      driver.executeScript(
        'return window.perceived ? window.perceived.apply(null, arguments) : null',
        role,
        plain(name) ?? null,
        within?.map(plain) ?? null,
      );
    const found = await look();
    if (found) return /** @type {WebElement[]} */ (found);
    await driver.executeScript(`${await readFile(QUERIES, 'utf8')}; window.perceived = ${perceived};`);
    return /** @type {WebElement[]} */ (await look());
  }

  /**
   * The one with a role and a name, waited for.
   * @param {string} role
   * @param {Name} [name]
   * @param {Place} [within]
   * @returns {Promise<WebElement>}
   */
  async function one(role, name, within) {
    /** @type {WebElement[]} */
    let found = [];
    await expect
      .poll(async () => (found = await all(role, name, within)).length, {
        message: `${role} ${name ?? ''} is there`,
        timeout: PATIENCE,
      })
      .toBeGreaterThan(0);
    return found[0];
  }

  /**
   * Clicks the control with a role and a name. It repeats the click if the control was replaced or covered at that
   * moment.
   * @param {string} role
   * @param {Name} [name]
   * @param {Place} [within]
   */
  async function click(role, name, within) {
    const clicked = expect(async () => (await one(role, name, within)).click()).toPass({
      timeout: 20_000,
      intervals: [200],
    });
    await inTime(clicked, PATIENCE + 10_000, `no answer to a click on ${role} ${name ?? ''}`);
  }

  /** Until all work for the page is done, and its crops are final. */
  async function idle() {
    await expect
      .poll(
        () =>
          driver
            .executeScript('const { idle, detected } = document.body.dataset; return `${idle} ${detected}`')
            // WebKit does not answer while it loads a page.
            .catch(() => 'loading'),
        { message: 'idle and detected', timeout: PATIENCE, intervals: [50] },
      )
      .toBe('true true');
  }

  /** @param {string} name of a button @param {Place} [within] */
  async function press(name, within) {
    await click('button', name, within);
    await idle();
  }

  /** Chooses files, as one does in the dialog of the browser. @param {string[]} files */
  async function choose(files) {
    // The page searches for the project of the last visit first, and accepts no files until then.
    const input = await driver.wait(
      async () =>
        /** @type {WebElement | null} */ (
          await driver.executeScript(
            `return [...document.querySelectorAll('input[type=file]')].find((input) => (input.getAttribute('aria-label') || input.labels[0] && input.labels[0].textContent || '').includes('Photos or video'))`,
          )
        ),
      60_000,
      'a place for photos',
    );
    await /** @type {WebElement} */ (input).sendKeys(files.join('\n'));
  }

  /**
   * @param {() => Promise<unknown>} act downloads a file
   * @returns {Promise<{ name: string, path: string, bytes: Buffer }>}
   */
  async function saved(act) {
    // In some browsers, a file of the same name replaces the previous one.
    const made = async (/** @type {string} */ name) => (await stat(join(downloads, name)).catch(() => null))?.mtimeMs;
    const before = new Map();
    for (const name of await readdir(downloads)) before.set(name, await made(name));
    await act();
    let last = '';
    await expect
      .poll(
        async () => {
          const names = await readdir(downloads);
          const times = await Promise.all(names.map(made));
          const fresh = names.filter((name, i) => before.get(name) !== times[i]);
          const whole = fresh.length === 1 && !/\.(part|crdownload|wkdownload|tmp)$/.test(fresh[0]);
          const bytes = whole ? await readFile(join(downloads, fresh[0])) : Buffer.alloc(0);
          const now = whole && bytes.length > 0 ? `${fresh[0]}/${bytes.length}` : '';
          const still = now !== '' && now === last;
          last = now;
          return still;
        },
        { message: 'a file is saved', timeout: PATIENCE, intervals: [200] },
      )
      .toBe(true);
    const name = last.slice(0, last.lastIndexOf('/'));
    return { name, path: join(downloads, name), bytes: await readFile(join(downloads, name)) };
  }

  return {
    driver,
    inPage,
    all,
    one,
    click,
    idle,
    press,
    choose,
    saved,
    Key,

    /**
     * Opens the page with the data that the browser stored. @param {{ detects?: boolean }} [how] whether it detects
     * faces
     */
    async open({ detects = false } = {}) {
      await driver.get(address);
      if (!detects) {
        await driver.executeScript("localStorage.setItem('inkpanel.detect', 'off')");
        await driver.navigate().refresh();
      }
      await driver.executeScript(
        `window.faults = [];
         addEventListener('error', ({ message }) => window.faults.push(message));
         addEventListener('unhandledrejection', ({ reason }) => window.faults.push(String(reason)));`,
      );
    },

    /** Errors that the page did not catch. @returns {Promise<string[]>} */
    faults: async () => (await driver.executeScript('return window.faults || []')) ?? [],

    async reload() {
      await driver.navigate().refresh();
      await idle();
    },

    /** The page with photos on the table, drawn. @param {string[]} files */
    async begin(files = SIX, /** @type {{ detects?: boolean }} */ how = {}) {
      await this.open(how);
      await choose(files);
      await one('region', 'Comic page');
      await idle();
    },

    /** Opens a tab next to the page. @param {'Styles' | 'Layouts' | 'Text' | 'Page'} name */
    tab: (name) => click('tab', name),

    /** A page of this size, independent of the browser's window. @param {{ width: number, height: number }} wanted */
    async resize({ width, height }) {
      const size = () => inPage(() => [innerWidth, innerHeight]);
      const window = driver.manage().window();
      await window.setRect({ width, height });
      const [across, down] = await size();
      await window.setRect({ width: 2 * width - across, height: 2 * height - down });
      await expect.poll(size).toEqual([width, height]);
      await idle();
    },

    /** @param {'Styles' | 'Layouts'} name of a list box, and of its tab @param {Name} option */
    async take(name, option) {
      await click('tab', name);
      await click('option', option, ['listbox', name]);
      await idle();
    },

    /** @param {string} name of a box to choose from @param {string} value */
    async select(name, value) {
      const box = await one('combobox', name);
      await driver.executeScript(
        `const [box, value] = arguments; box.focus(); box.value = value; box.dispatchEvent(new Event('input', { bubbles: true })); box.dispatchEvent(new Event('change', { bubbles: true }));`,
        box,
        value,
      );
    },

    /** @param {Name} name @param {string} text */
    async write(name, text) {
      const field = await one('textbox', name);
      await driver.executeScript('arguments[0].select?.()', field);
      await field.sendKeys(text, Key.ENTER);
      await idle();
    },

    /** The description of each panel for screen readers. */
    async shown() {
      const panels = await all('group', /^Panel \d/);
      const told = await Promise.all(panels.map((panel) => panel.getAttribute('aria-description')));
      return told.map((text) => text?.replace(/, selected.*/, ''));
    },

    /** The pixels of a canvas. @param {string} [selector] @returns {Promise<string>} */
    picture: (selector = '.page-canvas') =>
      driver.executeScript(
        // A copy, because WebKit cannot read pixels of a canvas that shows a transferred bitmap.
        `const shown = document.querySelector(arguments[0]);
         const copy = Object.assign(document.createElement('canvas'), { width: shown.width, height: shown.height });
         copy.getContext('2d').drawImage(shown, 0, 0);
         return copy.toDataURL();`,
        selector,
      ),

    /** @param {WebElement} what @param {[number, number]} by */
    async drag(what, [x, y]) {
      await driver
        .actions()
        .move({ origin: what, x: 0, y: 0 })
        .press()
        .move({ origin: Origin.POINTER, x: Math.round(x / 2), y: Math.round(y / 2), duration: 60 })
        .move({ origin: Origin.POINTER, x: Math.round(x / 2), y: Math.round(y / 2), duration: 60 })
        .release()
        .perform();
      await idle();
    },

    async openExport() {
      await press('Export');
      await one('dialog', 'Export');
    },

    /** Chooses a format in the export dialog. @param {string} way */
    async chooseFormat(way) {
      for (const name of WAYS[way]) if (name) await click('radio', name, ['dialog', 'Export']);
    },

    /** Saves the page as a kind of file, at half of its size. @param {string} format */
    async savedAs(format) {
      await this.openExport();
      await this.chooseFormat(format);
      await this.select('Resolution', '0.5');
      return saved(() => click('button', 'Download', ['dialog', 'Export']));
    },

    /** The project as a file. */
    async savedProject() {
      await press('Projects');
      const file = await saved(() => click('button', 'Save project file'));
      await press('Back to the page');
      return file;
    },

    /** Adds a balloon with this text. @param {string} text */
    async say(text) {
      await click('tab', 'Text');
      await click('button', 'Add balloon');
      await this.write(/^Text of/, text);
      await one('button', new RegExp(`^Balloon: ${text}`));
    },

    /** Waits until the app reports that everything is saved. */
    async kept() {
      const state = () => driver.executeScript("return document.querySelector('.save-state')?.textContent");
      await expect.poll(state, { timeout: PATIENCE }).toBe('Saved');
    },
  };
}
