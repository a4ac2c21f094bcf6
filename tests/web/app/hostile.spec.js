// @ts-check
/**
 * A thousand hostile files: whatever they are, the open project stays byte for byte what it was, the page comes to rest,
 * loads again, and needs no memory to speak of. `INKPANEL_SEED` begins with other seeds, `INKPANEL_HOSTILE` makes more.
 */

import { readFileSync } from 'node:fs';
import { hostilePage, hostileProject, soundPage, soundProject } from './hostile-files.js';
import { SMALL, goodFiles, saved } from './project-hands.js';
import { add, expect, idle, press, test } from './support.js';
import { tables } from './table-hands.js';

/** @typedef {import('./support.js').Page} Page */
/** @typedef {import('./hostile-files.js').Hostile} Hostile */

const FIRST_SEED = Number(process.env.INKPANEL_SEED ?? 20_260);
const COUNT = Number(process.env.INKPANEL_HOSTILE ?? 500);
/** Files between two looks at the tables. */
const BATCH = 50;
/** With the page loaded again after each. */
const RELOADED = 24;
/** Milliseconds that are told. */
const SLOW = 3_000;
/** Milliseconds until the page has come to rest. */
const REST = 10_000;
const GIGABYTE = 2 ** 30;

/** A project with a bit of everything, opened and saved. @param {Page} page */
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
  await saved(page);
  const id = String(await page.evaluate(() => sessionStorage.getItem('inkpanel.project')));
  // Its thumbnail comes a while after.
  await expect
    .poll(async () => (await tables(page, { of: id })).projects[id].picture, { timeout: 30_000 })
    .toContain('blob');
  return id;
}

/** What the page shows of the project that is open. @param {Page} page */
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
      [...document.querySelectorAll('.top-middle button, .shuffle-bar button')].map(
        (/** @type {any} */ button) => `${button.ariaLabel} ${button.disabled} ${button.ariaPressed}`,
      ),
      /** @type {HTMLCanvasElement | null} */ (document.querySelector('.page-canvas'))?.toDataURL('image/webp', 0.1),
    ]),
  );

/**
 * Drops files on the window one after the other, each when the page has come to rest after the one before.
 * @param {Page} page
 * @param {readonly Hostile[]} files
 * @returns {Promise<{ name: string, opened: boolean, told: boolean, said: string, rested: boolean, same: boolean, ms: number }[]>}
 */
function fed(page, files) {
  return page.evaluate(
    async ([list, rest]) => {
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
          }, rest);
          look();
        });
      const moment = () =>
        new Promise((resolve) => {
          setTimeout(resolve);
        });
      const results = [];
      for (const { name, base64 } of list) {
        const since = performance.now();
        const [before, view] = [at(), shown()];
        for (const close of /** @type {NodeListOf<HTMLButtonElement>} */ (
          document.querySelectorAll('.toast button[aria-label="Dismiss"]')
        ))
          close.click();
        const transfer = new DataTransfer();
        // By the browser: sign by sign a file of megabytes takes half a gigabyte, which would be measured as the page's.
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
          ms: Math.round(performance.now() - since),
        });
      }
      return results;
    },
    /** @type {const} */ ([files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') })), REST]),
  );
}

/**
 * The most memory that a tab of the browser ever had, its workers included, without what all processes of the browser share
 * of its program.
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

/** Frees what nothing holds any more: how long the browser waits with that is not the page's. @param {Page} page */
async function collectGarbage(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  await session.detach();
}

/** Back to the project that was open at first, as a person goes there. @param {Page} page */
async function backToFirst(page) {
  await page.getByRole('button', { name: 'Projects' }).click();
  await page.getByRole('region', { name: 'Projects' }).getByRole('button', { name: 'Open First', exact: true }).click();
  await idle(page);
}

// Pictures of each step would take longer than the steps.
test.use({ trace: 'off' });

test('a thousand hostile projects and pages leave the open project byte for byte as it was', async ({ page }) => {
  test.setTimeout(900_000);
  const id = await first(page);
  const good = await goodFiles(page);
  // What is spoilt is good before.
  for (const sound of [await soundProject(good.project), await soundPage(good.page)]) {
    const [result] = await fed(page, [sound]);
    expect(result, result.said).toMatchObject({ opened: true, rested: true });
    await expect(page.getByRole('alert')).toHaveText('');
    await backToFirst(page);
  }
  const before = { tables: await tables(page, { of: id }), look: await look(page) };
  let [opened, refused] = [0, 0];
  const begun = Date.now();
  for (const [kind, make, from] of /** @type {const} */ ([
    ['projects', hostileProject, good.project],
    ['pages', hostilePage, good.page],
  ])) {
    for (let seed = FIRST_SEED; seed < FIRST_SEED + COUNT; seed += BATCH) {
      const files = await Promise.all(
        Array.from({ length: Math.min(BATCH, FIRST_SEED + COUNT - seed) }, (_, i) => make(seed + i, from)),
      );
      const results = await fed(page, files);
      for (const { name, ms } of results)
        if (ms > SLOW) console.log(`${name} took ${ms} ms: ${files.find((file) => file.name === name)?.what}`);
      const about = (/** @type {string} */ name) => `${name}: ${files.find((file) => file.name === name)?.what}`;
      for (const result of results) {
        expect(result.rested, `${about(result.name)}: the page came to rest`).toBe(true);
        if (!result.opened) expect(result, about(result.name)).toMatchObject({ told: true, same: true });
      }
      opened += results.filter((result) => result.opened).length;
      refused += results.filter((result) => !result.opened).length;
      if (results.some((result) => result.opened)) await backToFirst(page);
      await collectGarbage(page);
      // A photo that comes is saved at once, and that it could not be read a moment later.
      await saved(page);
      expect(await look(page), `${kind} from ${seed}: what the page shows`).toBe(before.look);
      const now = await tables(page, { of: id });
      // Files that opened bring styles for all projects; saved with these it is the same project.
      const same = now.projects[id].stamp === before.tables.projects[id].stamp;
      expect(same ? now : essence(now), `${kind} from ${seed}: the tables`).toEqual(
        same ? before.tables : essence(before.tables),
      );
    }
  }
  const memory = await peak(page);
  console.log(
    `seeds from ${FIRST_SEED}: ${opened} opened, ${refused} refused, ${Math.round((Date.now() - begun) / 1000)} s, ${Math.round(memory / 2 ** 20)} MB at most`,
  );
  expect(memory).toBeLessThan(GIGABYTE);
  expect(Math.min(opened, refused)).toBeGreaterThan(COUNT / 10);
  // The document of the page, and not only its look, is what it was: an edit makes one step of it.
  await press(page, 'Lock layout');
  await saved(page);
  const after = (await tables(page, { of: id })).states[id].history;
  const { history } = before.tables.states[id];
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
});

/** Without the lists that all projects have in common: files that opened have brought theirs. @param {any} history */
function unshared({ past, present, future, ...rest }) {
  const own = (/** @type {any} */ { mine: _mine, favourites: _favourites, ownLayouts: _layouts, ...project }) =>
    project;
  return { ...rest, past: past.map(own), present: own(present), future: future.map(own) };
}

/** @param {Awaited<ReturnType<typeof tables>>} all of one project, without what any writing of it changes */
function essence({ projects, states, ...rest }) {
  const about = Object.values(projects).map(
    ({ changed: _changed, stamp: _stamp, picture: _picture, ...record }) => record,
  );
  const kept = Object.values(states).map(({ stamp: _stamp, history, ...record }) => ({
    ...record,
    history: unshared(history),
  }));
  return { about, kept, ...rest };
}

/** @param {Page} page @param {string} id */
async function contentsOf(page, id) {
  return (await tables(page, { of: id })).states[id].history;
}

test('after a hostile file the page loads again, whatever is open then', async ({ page }) => {
  await first(page);
  const good = await goodFiles(page);
  for (let seed = FIRST_SEED - RELOADED; seed < FIRST_SEED; seed += 1) {
    const file = await (seed % 2 === 0 ? hostileProject(seed, good.project) : hostilePage(seed, good.page));
    await test.step(`${file.name}: ${file.what}`, async () => {
      const [result] = await fed(page, [file]);
      expect(result.rested, file.what).toBe(true);
      await saved(page);
      const open = JSON.parse(await look(page));
      await page.reload();
      await page.waitForFunction(() => document.body.dataset.idle === 'true', undefined, { timeout: REST });
      expect(JSON.parse(await look(page)).slice(0, 4), file.what).toEqual(open.slice(0, 4));
      await expect(page.getByRole('group', { name: /cannot be shown/ })).toHaveCount(0);
    });
  }
});
