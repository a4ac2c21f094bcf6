// @ts-check
/**
 * Shared helpers of the app tests: a page that is checked for errors and for requests to other origins, and common
 * steps.
 */

import { readFile } from 'node:fs/promises';
import { AxeBuilder, PNG, expect, test as plain } from '../../../www/testing.ts';

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** Options of a test. `detects`: whether the app looks for faces and objects. `isWatched`: whether faults of the page fail the test. @typedef {{ detects: boolean, isWatched: boolean }} Own */
/** A page that tests share: the key of these tests, and its state after it was opened. @typedef {{ key: string, open?: Open, page: Page, start: string }} Shared */
/** Brings a page to the state that tests start from. @typedef {(page: Page) => Promise<unknown>} Open */

/** A file that is added to the app. @typedef {{ name: string, mimeType: string, buffer: Buffer }} File */
/**
 * The board that tests share: whether the app was opened, its files, and its state and its picture after they were added.
 * @typedef {{ isUsed?: boolean, names?: string, start?: string, picture?: string }} Board
 */

/** Photos that are not part of the site. */
const PHOTOS = new URL('../../photos/', import.meta.url);

/**
 * Replaces random seeds by a fixed sequence. It goes on after a reload, so that no seed comes twice. Ids remain random,
 * because tabs must not have the same ids.
 */
function fixSeeds() {
  const random = crypto.getRandomValues.bind(crypto);
  const loads = Number(/^loads: (\d+)$/.exec(window.name)?.[1] ?? 0);
  window.name = `loads: ${loads + 1}`;
  let state = Math.imul(loads + 1, 0x9e3779b9) >>> 0;
  // The generator mulberry32.
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61)) ^ mixed;
    return (mixed ^ (mixed >>> 14)) >>> 0;
  };
  crypto.getRandomValues = (values) => {
    if (!(values instanceof Uint32Array)) return random(values);
    values.set(values.map(next));
    return values;
  };
}

/** Makes chance repeatable. @param {Page} page @param {boolean} detects */
async function prepare(page, detects) {
  await page.addInitScript(fixSeeds);
  // Titles and captions of new pages would be among the text items that tests add. Frames share what the page sets, or are of
  // another origin, where a test expects that nothing is stored.
  const settings = ['inkpanel.narration', ...(detects ? [] : ['inkpanel.detect'])];
  await page.addInitScript((off) => {
    if (window === window.top && location.protocol.startsWith('http'))
      for (const setting of off) localStorage.setItem(setting, 'off');
  }, settings);
}

/** Errors of pages and their requests to other origins. @type {WeakMap<Page, string[]>} */
const FAULTS = new WeakMap();

/** Notes the faults of a page. @param {Page} page @param {string} baseURL */
function watch(page, baseURL) {
  const { origin } = new URL(baseURL);
  /** @type {string[]} */
  const wrong = [];
  FAULTS.set(page, wrong);
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (!['blob:', 'data:'].includes(url.protocol) && url.origin !== origin) wrong.push(`request to ${url}`);
  });
  page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
  page.on('console', (message) => {
    if (message.type() === 'error') wrong.push(`console: ${message.text()}`);
  });
}

/** @param {Page} page @returns {string[]} its faults since the last call */
const faultsOf = (page) => FAULTS.get(page)?.splice(0) ?? [];

/**
 * A test with a new page, which must make no request to another origin and have no error.
 * @type {import('../../../www/testing.ts').TestWith<Own>}
 */
export const test = plain.extend(
  /** @type {any} */ ({
    detects: [false, { option: true }],
    isWatched: [true, { option: true }],
    shared: [
      async (/** @type {{}} */ {}, /** @type {(shared: { now?: Shared }) => Promise<void>} */ use) => {
        const shared = /** @type {{ now?: Shared }} */ ({});
        await use(shared);
        await shared.now?.page.context().close();
      },
      { scope: 'worker' },
    ],
    page: async (
      /** @type {any} */ { page, baseURL, detects, isWatched },
      /** @type {(page: Page) => Promise<void>} */ use,
    ) => {
      await prepare(page, detects);
      if (isWatched) watch(page, baseURL);
      await use(page);
      expect(faultsOf(page)).toEqual([]);
    },
  }),
);

/** A test of an app that looks for faces and objects, which takes time. */
export const detectingTest = test.extend(/** @type {any} */ ({ detects: [true, { option: true }] }));

/** A test in which errors and requests to other origins may happen. */
export const faultTest = test.extend(/** @type {any} */ ({ isWatched: [false, { option: true }] }));

/**
 * Tests that share one page, as opening a board takes seconds. Each test should end where it began: with the same panels,
 * screen and settings. Otherwise, and after a failure, the page is opened again for the next test. Scripts, listeners,
 * routes, clocks and media settings of a test would stay in the page: such a test uses `test`.
 * @param {Open} [open] without it, each test begins with `openBoard` or `openStart`
 */
export const testsOn = (open) =>
  test.extend(
    /** @type {any} */ ({
      page: async (
        /** @type {any} */ {
          browser,
          shared,
          baseURL,
          detects,
          bypassCSP,
          colorScheme,
          contextOptions,
          deviceScaleFactor,
          hasTouch,
          isMobile,
          locale,
          viewport,
        },
        /** @type {(page: Page) => Promise<void>} */ use,
        /** @type {import('../../../www/testing.ts').TestInfo} */ info,
      ) => {
        const options = { bypassCSP, colorScheme, contextOptions, deviceScaleFactor, hasTouch, isMobile, locale };
        const key = JSON.stringify([info.file, detects, viewport, options]);
        const { now } = shared;
        const isOpen = now && now.key === key && now.open === open;
        const left = isOpen && open ? difference(now.start, await stateOf(now.page)) : '';
        if (!isOpen || left !== '') {
          if (left !== '') console.log(`opened again for "${info.title}", as the test before left: ${left}`);
          await now?.page.context().close();
          const page = await (await browser.newContext()).newPage();
          await prepare(page, detects);
          watch(page, baseURL);
          if (open) await open(page);
          else BOARDS.set(page, {});
          shared.now = { key, open, page, start: open ? await stateOf(page) : '' };
        }
        const { page } = shared.now;
        await use(page);
        const context = page.context();
        await Promise.all(context.pages().map((/** @type {Page} */ other) => (other === page ? null : other.close())));
        await context.clearPermissions();
        await page.unrouteAll({ behavior: 'ignoreErrors' });
        await page.setViewportSize(viewport);
        const reducedMotion = contextOptions?.reducedMotion ?? 'no-preference';
        await page.emulateMedia({ colorScheme: colorScheme ?? 'light', reducedMotion });
        expect(faultsOf(page)).toEqual([]);
      },
      context: async (
        /** @type {{ page: Page }} */ { page },
        /** @type {(context: ReturnType<Page['context']>) => Promise<void>} */ use,
      ) => use(page.context()),
    }),
  );

/** Tests that share a board of six photos. */
export const boardTest = testsOn((page) => openBoard(page));

/** The boards of shared pages. @type {WeakMap<Page, Board>} */
const BOARDS = new WeakMap();

/** Tests that share a page. `openBoard` undoes what the tests before did. */
export const sharedBoardTest = testsOn();

/**
 * The state of a page: its panels, the open screen, and all selected, pressed or filled controls. One line for each.
 * @param {Page} page
 * @returns {Promise<string>}
 */
const stateOf = (page) =>
  page
    .evaluate(() => {
      const states = [...document.querySelectorAll('button, summary, input, select, textarea, [role], .panel, dialog')]
        .filter((one) => one.checkVisibility() && !one.closest('.alternatives'))
        .map((one) => {
          const { value, checked, disabled } = /** @type {HTMLInputElement} */ (one);
          const name = one.getAttribute('aria-label') ?? one.textContent;
          const is = ['aria-pressed', 'aria-selected', 'aria-current'].map((of) => one.getAttribute(of) === 'true');
          if (one.matches('input, select, textarea')) return `${name}: ${value} ${checked}`;
          if (one.matches('.panel')) return `${name}: ${one.getAttribute('aria-description')}`;
          if (one.matches('dialog[open], .workspace')) return `${name} is open`;
          if (is.includes(true)) return `${name} is on`;
          // Buttons that show whether there is something to undo, and whether the page is enlarged.
          return name === 'Undo' || name === 'Shrink page' ? `${name}: ${disabled}` : '';
        });
      const { lang, dataset } = document.documentElement;
      return [`${innerWidth} x ${innerHeight}`, lang, JSON.stringify(dataset), ...states].filter(Boolean).join('\n');
    })
    .catch((error) => String(error));

/** @param {string} before @param {string} after @returns {string} the lines that only one of two states has */
function difference(before, after) {
  const [old, now] = [before.split('\n'), after.split('\n')];
  const lines = [...now.filter((line) => !old.includes(line)), ...old.filter((line) => !now.includes(line))];
  return lines.join('; ').slice(0, 400);
}

/**
 * One step of a test. A fault of the page fails the test, and the next step runs all the same.
 * @param {Page} page
 * @param {string} title
 * @param {() => Promise<void>} body
 */
export const step = (page, title, body) =>
  test.step(title, async () => {
    await body();
    expect.soft(faultsOf(page), title).toEqual([]);
  });

export { PNG, expect };

/**
 * @param {...string} names of files in `tests/photos`
 * @returns {Promise<File[]>}
 */
export function photos(...names) {
  return Promise.all(
    names.map(async (name) => ({ name, mimeType: 'image/jpeg', buffer: await readFile(new URL(name, PHOTOS)) })),
  );
}

/** The photos of the sample album, for `openBoard`. */
export const SAMPLES = ['sample album'];

/** Six photos: enough for a comic page, and quick to read. */
export const SIX = ['bee.jpg', 'cat.jpg', 'crab.jpg', 'gateway.jpg', 'macaw.jpg', 'temple.jpg'];

/**
 * Waits until the page is drawn and its crops are final, because detection may still move them.
 * @param {Page} page
 */
export async function idle(page) {
  await page.waitForFunction(() => document.body.dataset.idle === 'true' && document.body.dataset.detected === 'true');
}

/**
 * Opens the start screen, without stored data if tests share the page.
 * @param {Page} page
 */
export async function openStart(page) {
  const board = BOARDS.get(page);
  if (board?.isUsed) {
    const { origin } = new URL(page.url());
    await page.goto('about:blank');
    const session = await page.context().newCDPSession(page);
    await session.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
    await session.detach();
  }
  if (board) Object.assign(board, { isUsed: true, names: undefined });
  await page.goto('./');
}

/**
 * Opens a board with photos, and waits until its comic page is drawn. If tests share the page, it undoes what they did.
 * @param {Page} page
 * @param {string[]} [names]
 * @param {File[]} [files] by default: the photos of these names in `tests/photos`
 */
export async function openBoard(page, names = SIX, files) {
  const board = BOARDS.get(page);
  if (board?.names === names.join() && (await returnToStart(page, board))) return;
  await openNewBoard(page, names, files);
}

/**
 * Like `openBoard`, for tests that need a board without earlier versions of the page.
 * @param {Page} page
 * @param {string[]} [names]
 * @param {File[]} [files]
 */
export async function openNewBoard(page, names = SIX, files) {
  await openStart(page);
  if (names === SAMPLES) await page.getByRole('button', { name: 'Try the sample album' }).click();
  else await add(page, files ?? (await photos(...names)));
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  const board = BOARDS.get(page);
  // Inactive tabs get their content after the first page.
  await expect(page.locator('.side-panel:empty')).toHaveCount(0);
  if (board) Object.assign(board, { names: names.join(), start: await stateOf(page), picture: await picture(page) });
}

/**
 * Leaves the dialogs and modes of a board and undoes all edits.
 * @param {Page} page
 * @param {Board} board
 * @returns {Promise<boolean>} whether the board is as it was at the start
 */
async function returnToStart(page, board) {
  if (page.url() === 'about:blank') return false;
  await page.mouse.move(0, 0);
  for (let i = 0; i < 3; i += 1) {
    await page.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
    await page.keyboard.press('Escape');
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  }
  await page.evaluate(async () => {
    const click = async (/** @type {string} */ selector) => {
      const button = /** @type {HTMLElement | null} */ (document.querySelector(selector));
      button?.click();
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      return button !== null;
    };
    await click('.side-tabs [role=tab]:first-child[aria-selected=false]');
    await click('.context-bar .tool[aria-expanded=true]');
    while (await click('.toasts [aria-label=Dismiss]'));
    while (await click('.top-bar [aria-label=Undo]:enabled'));
  });
  await idle(page);
  const left = difference(board.start ?? '', await stateOf(page));
  const isDrawn = (await picture(page)) === board.picture;
  if (left !== '' || !isDrawn) console.log(`opened again for "${test.info().title}": ${left || 'another picture'}`);
  return left === '' && isDrawn;
}

/**
 * @param {Page} page
 * @param {File[]} files
 */
export async function add(page, files) {
  await page.getByLabel('Photos or video').setInputFiles(files);
}

/** Closes all alerts. @param {Page} page */
export async function dismissAlerts(page) {
  const buttons = page.getByRole('alert').getByRole('button', { name: 'Dismiss' });
  while ((await buttons.count()) > 0) await buttons.first().click();
}

/**
 * Drops files on the window, like a user.
 * @param {Page} page
 * @param {File[]} files
 * @param {{ altKey?: boolean }} [keys] held meanwhile
 */
export async function drop(page, files, keys = {}) {
  const plainFiles = files.map(({ name, mimeType, buffer }) => ({ name, mimeType, base64: buffer.toString('base64') }));
  const transfer = await page.evaluateHandle((list) => {
    const made = new DataTransfer();
    for (const { name, mimeType, base64 } of list) {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      made.items.add(new File([bytes], name, { type: mimeType }));
    }
    return made;
  }, plainFiles);
  for (const type of ['dragenter', 'dragover', 'drop'])
    await page.dispatchEvent('body', type, { dataTransfer: transfer, ...keys });
}

/**
 * Clicks, and waits until the page that follows is drawn.
 * @param {Page} page
 * @param {string} name of a button
 */
export async function press(page, name) {
  await (await reach(page, name)).click();
  await idle(page);
}

/**
 * Returns a button. Opens `More` of the tools if the button is not visible without it.
 * @param {Page} page
 * @param {string} name
 */
export async function reach(page, name) {
  const button = page.getByRole('button', { name, exact: true });
  const more = page.locator('.context-bar .tool[aria-expanded=false]');
  if (!(await button.first().isVisible()) && (await more.isVisible()))
    await more.evaluate((element) => /** @type {HTMLElement} */ (element).click());
  return button;
}

/**
 * Opens a tab next to the page. Small screens have no tabs, so nothing happens there.
 * @param {Page} page
 * @param {'Styles' | 'Layouts' | 'Text' | 'Page'} name
 */
export async function tab(page, name) {
  const found = page.getByRole('tab', { name, exact: true });
  if (await found.isVisible()) await found.click();
}

/**
 * Takes a layout by its name.
 * @param {Page} page
 * @param {string} family
 * @param {string} name
 */
export async function choose(page, family, name) {
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Family' }).selectOption(family);
  await page.getByRole('listbox', { name: 'Layouts' }).getByRole('option', { name, exact: true }).click();
  await idle(page);
  await page.getByRole('combobox', { name: 'Family' }).selectOption('');
}

/**
 * Makes the comic page 600 pixels wide. A file in print size takes seconds.
 * @param {Page} page
 */
export async function makePageSmall(page) {
  await tab(page, 'Page');
  const settings = page.getByRole('region', { name: 'Page settings' });
  await settings.getByLabel('Page size').selectOption('custom');
  await settings.getByLabel('Width').fill('600');
  await settings.getByLabel('Height').fill('848');
  await idle(page);
}

/**
 * The visible state of the page: the selected layout and style, and the photo in each panel.
 * @param {Page} page
 */
export async function contents(page) {
  // One of the lists is behind the other's tab.
  const chosen = (/** @type {string} */ name) =>
    page
      .getByRole('listbox', { name, includeHidden: true })
      .getByRole('option', { selected: true, includeHidden: true })
      .getAttribute('aria-label');
  const panels = page.getByRole('region', { name: 'Comic page' }).getByRole('group', { name: /^Panel \d/ });
  return {
    layout: await chosen('Layouts'),
    style: await chosen('Styles'),
    photos: await panels.evaluateAll((list) => list.map((panel) => panel.getAttribute('aria-description'))),
  };
}

/**
 * @param {Page} page
 * @returns {Promise<string>} the picture of the page on the screen
 */
export function picture(page) {
  return page.locator('.page-canvas').evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
}

/**
 * @param {string} address a data address of a PNG, as `picture` returns
 * @returns {PNG}
 */
export function pixelsOf(address) {
  return PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
}

/**
 * @param {string} a a data address of a PNG, as `picture` returns
 * @param {string} b another of the same size
 * @returns {number} number of pixels whose red values differ visibly
 */
export function different(a, b) {
  const [one, other] = [pixelsOf(a), pixelsOf(b)];
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4) if (Math.abs(one.data[i] - other.data[i]) > 24) count += 1;
  return count;
}

/**
 * @param {PNG} png
 * @returns {number} the different colours among some thousand pixels spread over it: one in a blank picture
 */
export function colours({ data }) {
  const seen = new Set();
  const step = 4 * Math.max(1, Math.floor(data.length / 4 / 5003));
  for (let i = 0; i < data.length; i += step) seen.add(data.readUInt32LE(i));
  return seen.size;
}

/**
 * Finds nothing against WCAG 2.2 AA, the size of targets included, nor against the good practices of axe.
 * @param {Page} page
 */
export async function accessible(page) {
  expect(await offences(page)).toEqual([]);
}

/**
 * Runs axe after all fade-ins, because it would report half-transparent text as low contrast.
 * @param {Page} page
 * @param {string[]} [only] the rules to run; by default all
 */
export async function offences(page, only) {
  await page.evaluate(() =>
    Promise.allSettled(
      document
        .getAnimations()
        .filter(({ effect }) => Number.isFinite(effect?.getComputedTiming().endTime))
        .map(({ finished }) => finished),
    ),
  );
  // In legacy mode, because no frame has another origin. Otherwise the results go through a second page, which takes
  // four times as long.
  const axe = new AxeBuilder({ page }).setLegacyMode(true);
  const rules = only ? { runOnly: only } : { rules: { 'target-size': { enabled: true } } };
  const { violations } = await axe.options({ ...rules, resultTypes: ['violations'] }).analyze();
  return violations.map(({ id, nodes }) => ({ id, nodes: nodes.map((node) => node.html.slice(0, 160)) }));
}
