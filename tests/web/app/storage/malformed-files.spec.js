// @ts-check
/**
 * Malformed project files and pages: each one is opened or rejected, no byte of the open project changes, and the app loads again
 * within its memory. `www/storage/files/malformed-files.test.ts` opens a thousand of them without a browser.
 * `INKPANEL_SEED` sets the first seed, `INKPANEL_MALFORMED` the number of files of each kind.
 */

import { readFileSync } from 'node:fs';
import {
  essence,
  historyIn,
  malformedPage,
  malformedProject,
  soundPage,
  soundProject,
  unshared,
} from '../malformed-files.js';
import { SMALL, expectSaved, goodFiles } from '../project-files.js';
import { add, expect, idle, press, test } from '../support.js';
import { tables } from '../database.js';

/** @typedef {import('../support.js').Page} Page */
/** @typedef {import('../malformed-files.js').Malformed} Malformed */

const FIRST_SEED = Number(process.env.INKPANEL_SEED ?? 20_260);
/** Number of files of each kind. */
const FEW = 30;
const MANY = Number(process.env.INKPANEL_MALFORMED ?? 500);
/** Number of files between two checks of the database. */
const BATCH = 50;
/** Number of files after which the app is loaded again. */
const RELOADED = 6;
/** Milliseconds after which the app hangs. */
const HANGS = 120_000;
const GIGABYTE = 2 ** 30;

/** Makes and saves a project with two pages, versions and a favourite. @param {Page} page */
async function first(page) {
  await page.goto('./');
  await add(page, SMALL);
  await idle(page);
  await page.getByLabel('Project name').fill('First');
  await page.keyboard.press('Enter');
  await press(page, 'Shuffle');
  await press(page, 'Add page');
  await press(page, 'Lock style');
  await press(page, 'Shuffle');
  await press(page, 'Favourite page');
  await expectSaved(page);
  const id = String(await page.evaluate(() => sessionStorage.getItem('inkpanel.project')));
  // The thumbnail is drawn after a pause.
  await expect
    .poll(async () => (await tables(page, { of: id })).projects[id].picture, { timeout: 30_000 })
    .toContain('blob');
  return id;
}

/** Returns the visible state of the open project. @param {Page} page */
const look = (page) =>
  page.evaluate(() =>
    JSON.stringify([
      sessionStorage.getItem('inkpanel.project'),
      document.querySelector('.project-name')?.getAttribute('value') ??
        /** @type {any} */ (document.querySelector('.project-name'))?.value,
      document.querySelector('.page-number')?.textContent,
      [...document.querySelectorAll('.stage [aria-description]')].map((panel) =>
        panel.getAttribute('aria-description'),
      ),
      [...document.querySelectorAll('.steps button, .shuffle-bar button')].map(
        (/** @type {any} */ button) => `${button.ariaLabel} ${button.disabled} ${button.ariaPressed}`,
      ),
      /** @type {HTMLCanvasElement | null} */ (document.querySelector('.page-canvas'))?.toDataURL('image/webp', 0.1),
    ]),
  );

/**
 * Drops files on the window. Each file waits until the app is idle after the file before it.
 * @param {Page} page
 * @param {readonly Malformed[]} files
 * @returns {Promise<{ name: string, opened: boolean, told: boolean, said: string, rested: boolean, same: boolean }[]>}
 */
function fed(page, files) {
  return page.evaluate(
    async ([list, limit]) => {
      const at = () => sessionStorage.getItem('inkpanel.project');
      const shown = () =>
        JSON.stringify(
          [...document.querySelectorAll('.stage [aria-description], .project-name')].map(
            (one) => one.getAttribute('aria-description') ?? /** @type {any} */ (one).value,
          ),
        );
      const said = () => [...document.querySelectorAll('.toasts')].map(({ textContent }) => textContent).join();
      /** @type {() => Promise<boolean>} */
      const resting = () =>
        new Promise((resolve) => {
          const over = () => {
            watch.disconnect();
            clearTimeout(timer);
          };
          const look = () => {
            if (document.body.dataset.idle === 'true') {
              over();
              resolve(true);
            }
          };
          const watch = new MutationObserver(look);
          watch.observe(document.body, { attributes: true, attributeFilter: ['data-idle'] });
          const timer = setTimeout(() => {
            over();
            resolve(false);
          }, limit);
          look();
        });
      const moment = () =>
        new Promise((resolve) => {
          setTimeout(resolve);
        });
      const results = [];
      for (const { name, base64 } of list) {
        const [before, view] = [at(), shown()];
        for (const close of /** @type {NodeListOf<HTMLButtonElement>} */ (
          document.querySelectorAll('.toast button[aria-label="Dismiss"]')
        ))
          close.click();
        const transfer = new DataTransfer();
        // `atob` would take half a gigabyte for a file of megabytes, which the test would measure as memory of the app.
        const bytes = /** @type {any} */ (Uint8Array).fromBase64(base64);
        transfer.items.add(new File([bytes], name, { type: name.endsWith('png') ? 'image/png' : 'application/zip' }));
        for (const type of ['dragenter', 'dragover', 'drop'])
          document.body.dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
        await moment();
        const rested = await resting();
        // Messages are rendered a moment later.
        await moment();
        results.push({
          name,
          opened: at() !== before,
          told: said().includes(name),
          said: said(),
          rested,
          same: shown() === view,
        });
      }
      return results;
    },
    /** @type {const} */ ([files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') })), HANGS]),
  );
}

/**
 * Returns the maximum memory that a tab of the browser had so far, with its workers, and without the program files that all
 * processes share.
 * @param {Page} page
 */
async function peak(page) {
  const session = await /** @type {any} */ (page.context().browser()).newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const sizes = processInfo
    .filter((/** @type {any} */ { type }) => type === 'renderer')
    .map((/** @type {any} */ { id }) => {
      try {
        const status = readFileSync(`/proc/${id}/status`, 'utf8');
        const of = (/** @type {string} */ what) =>
          Number(new RegExp(`^${what}:\\s+(\\d+) kB`, 'm').exec(status)?.[1] ?? 0);
        return (of('VmHWM') - of('RssFile')) * 1024;
      } catch {
        return 0;
      }
    });
  return Math.max(0, ...sizes);
}

/** Frees unused memory. @param {Page} page */
async function collectGarbage(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  await session.detach();
}

/** Opens the first project again. @param {Page} page */
async function backToFirst(page) {
  await page.getByRole('button', { name: 'Projects' }).click();
  await page.getByRole('region', { name: 'Projects' }).getByRole('button', { name: 'Open First', exact: true }).click();
  await idle(page);
}

// A trace of each step takes longer than the step.
test.use({ trace: 'off' });

/**
 * Opens malformed files, and checks that the open project does not change, and that the app stays within its memory.
 * @param {Page} page
 * @param {number} count of files of each kind
 */
async function openMalformed(page, count) {
  const id = await first(page);
  const good = await goodFiles(page);
  // The files can be opened before they are damaged.
  for (const sound of [await soundProject(good.project), await soundPage(good.page)]) {
    const [result] = await fed(page, [sound]);
    expect(result, result.said).toMatchObject({ opened: true, rested: true });
    await expect(page.getByRole('alert')).toHaveText('');
    await backToFirst(page);
  }
  const before = { tables: await tables(page, { of: id }), look: await look(page) };
  let [opened, refused] = [0, 0];
  for (const [kind, make, from] of /** @type {const} */ ([
    ['projects', malformedProject, good.project],
    ['pages', malformedPage, good.page],
  ])) {
    for (let seed = FIRST_SEED; seed < FIRST_SEED + count; seed += BATCH) {
      const files = await Promise.all(
        Array.from({ length: Math.min(BATCH, FIRST_SEED + count - seed) }, (_, i) => make(seed + i, from)),
      );
      const results = await fed(page, files);
      const about = (/** @type {string} */ name) => `${name}: ${files.find((file) => file.name === name)?.what}`;
      for (const result of results) {
        expect(result.rested, `${about(result.name)}: the app is idle`).toBe(true);
        if (!result.opened) expect(result, about(result.name)).toMatchObject({ told: true, same: true });
      }
      opened += results.filter((result) => result.opened).length;
      refused += results.filter((result) => !result.opened).length;
      if (results.some((result) => result.opened)) await backToFirst(page);
      await collectGarbage(page);
      // A new photo is saved at once, and its read error a moment later.
      await expectSaved(page);
      expect(await look(page), `${kind} from ${seed}: the visible state`).toBe(before.look);
      const now = await tables(page, { of: id });
      // Files that were opened add styles to the lists of all projects, which are saved with the project.
      const same = now.projects[id].stamp === before.tables.projects[id].stamp;
      expect(same ? now : essence(now), `${kind} from ${seed}: the database`).toEqual(
        same ? before.tables : essence(before.tables),
      );
    }
  }
  const memory = await peak(page);
  console.log(`${opened} opened, ${refused} rejected, at most ${Math.round(memory / 2 ** 20)} MB`);
  expect(memory).toBeLessThan(GIGABYTE);
  expect(Math.min(opened, refused)).toBeGreaterThan(count / 10);
  // The document in memory is unchanged too: an edit adds one step to it.
  await press(page, 'Lock layout');
  await expectSaved(page);
  const after = await contentsOf(page, id);
  const history = historyIn(before.tables.states[id]);
  const wanted = {
    ...history,
    past: [...history.past, history.present],
    future: [],
    present: { ...history.present, locks: { ...history.present.locks, layout: true } },
  };
  expect(unshared(after)).toEqual(unshared(wanted));
  await page.reload();
  await idle(page);
  expect(await contentsOf(page, id)).toEqual(after);
}

test('60 malformed projects and pages leave the open project as it was, byte for byte', ({ page }) =>
  openMalformed(page, FEW));

test('1,000 malformed projects and pages leave the open project as it was, byte for byte', { tag: '@nightly' }, async ({
  page,
}) => {
  test.setTimeout(1_800_000);
  await openMalformed(page, MANY);
});

/** @param {Page} page @param {string} id */
async function contentsOf(page, id) {
  return historyIn((await tables(page, { of: id })).states[id]);
}

test('the app loads again after a malformed file', async ({ page }) => {
  await first(page);
  const good = await goodFiles(page);
  for (let seed = FIRST_SEED - RELOADED; seed < FIRST_SEED; seed += 1) {
    const file = await (seed % 2 === 0 ? malformedProject(seed, good.project) : malformedPage(seed, good.page));
    await test.step(`${file.name}: ${file.what}`, async () => {
      const [result] = await fed(page, [file]);
      expect(result.rested, file.what).toBe(true);
      await expectSaved(page);
      const open = JSON.parse(await look(page));
      await page.reload();
      await page.waitForFunction(() => document.body.dataset.idle === 'true');
      expect(JSON.parse(await look(page)).slice(0, 4), file.what).toEqual(open.slice(0, 4));
      await expect(page.getByRole('group', { name: /cannot be shown/ })).toHaveCount(0);
    });
  }
});
