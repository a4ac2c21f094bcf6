// @ts-check
/** Waiting times in the built app: the first page, Shuffle, and export. */

/** @typedef {import('playwright-core').Browser} Browser */

export const SHUFFLES = 15;
/** Milliseconds between a page and the next Shuffle. */
export const REST = 600;
/** Milliseconds that a user needs to choose photos. */
export const CHOOSING = 3_000;
/** Number of rapid Shuffles in the first ten seconds. */
const HURRIED = 40;
const FIRST_SECONDS = 10_000;
const RESIZES = 8;

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ firstPage: number, drawn: number, decoded: number, refined: number, closer: number, shuffle: number, rested: number, hurried: { count: number, ms: number }, png: number, thumbnails: number, listed: number }>} milliseconds;
 *   `drawn`: until the first page appears. `firstPage`: until all photos are read as well. `decoded`: the time in which the browser
 *   decodes the same files. `refined`: from the first page to the end of detection. `closer`: including the search for small faces.
 */
export async function journey(browser, address, photos) {
  const hurriedShuffles = await inTheFirstSeconds(browser, address, photos);
  const decoded = await browserDecodes(browser, photos);
  const { page, firstPage, drawn } = await opened(browser, address, photos);
  const [refined, closer] = await page.evaluate(async () => {
    const start = performance.now();
    // A loop of animation frames would have the browser draw sixty times a second what does not change.
    const until = (/** @type {'searched' | 'detected'} */ flag) =>
      new Promise((resolve) => {
        const look = () => {
          if (document.body.dataset[flag] === 'true') resolve(performance.now() - start);
        };
        new MutationObserver(look).observe(document.body, { attributes: true });
        look();
      });
    return [await until('searched'), await until('detected')];
  });
  const times = [];
  for (let i = 0; i < SHUFFLES; i += 1) times.push(await shuffled(page));
  const rests = [];
  for (let i = 0; i < SHUFFLES; i += 1) {
    await page.waitForTimeout(REST);
    rests.push(await shuffled(page));
  }
  const resizes = [];
  await page.getByRole('tab', { name: 'Page', exact: true }).click();
  for (let i = 0; i < RESIZES; i += 1) {
    const size = page.getByRole('combobox', { name: 'Page size' });
    resizes.push(
      await size.evaluate(
        (select, to) => /** @type {any} */ (globalThis).watch.afterChange(select, to),
        i % 2 ? 'a4' : 'letter',
      ),
    );
    await page.waitForFunction(() => document.body.dataset.idle === 'true');
  }
  await page.getByRole('tab', { name: 'Layouts', exact: true }).click();
  const listed = await page.getByRole('listbox', { name: 'Layouts' }).getByRole('option').count();
  const start = performance.now();
  const [download] = await Promise.all([
    page.waitForEvent('download', { timeout: 120_000 }),
    page.getByRole('button', { name: 'Download PNG', exact: true }).click(),
  ]);
  await download.path();
  const png = performance.now() - start;
  await page.close();
  const [shuffle, rested, thumbnails] = [median(times), median(rests), median(resizes)];
  return {
    firstPage,
    drawn,
    decoded,
    refined,
    closer,
    shuffle,
    rested,
    hurried: hurriedShuffles,
    png,
    thumbnails,
    listed,
  };
}

/** @param {number[]} list */
export function median(list) {
  return list.toSorted((a, b) => a - b)[list.length >> 1];
}

/**
 * The page with photos on it, and how long the first page took.
 * @param {Browser} browser
 * @param {string} address
 * @param {string[]} photos
 * @template [T=undefined]
 * @param {{ lacks?: RegExp, before?: (page: import('playwright-core').Page) => Promise<T> }} [options] `lacks`: files that
 *   the site does not have; `before` runs when the user has chosen the photos
 */
export async function opened(browser, address, photos, { lacks, before } = {}) {
  const page = await browser.newPage({
    viewport: { width: 1920, height: 1080 },
    serviceWorkers: 'block',
    acceptDownloads: true,
  });
  await page.addInitScript(watch);
  if (lacks) await page.route(lacks, (route) => route.fulfill({ status: 404 }));
  await page.goto(address);
  const [dialog] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Choose photos or a video' }).click(),
  ]);
  // Users need at least this time to choose photos.
  await page.waitForTimeout(CHOOSING);
  const said = /** @type {T} */ (await before?.(page));
  const first = page.evaluate(() => /** @type {any} */ (globalThis).watch.afterChoosing());
  await dialog.setFiles(photos);
  const times = /** @type {{ firstPage: number, drawn: number, sketched: number }} */ (await first);
  return { page, before: said, ...times };
}

/**
 * Decodes the same files with the browser's decoder, with its own parallelism.
 * @param {Browser} browser
 * @param {string[]} photos
 */
export async function browserDecodes(browser, photos) {
  const page = await browser.newPage();
  await page.setContent('<input type="file" multiple>');
  await page.locator('input').setInputFiles(photos);
  const ms = await page.evaluate(async () => {
    const files = [...(document.querySelector('input')?.files ?? [])];
    const start = performance.now();
    await Promise.all(files.map(async (file) => (await createImageBitmap(file)).close()));
    return performance.now() - start;
  });
  await page.close();
  return ms;
}

/**
 * Shuffles while detection and the alternatives are running.
 * @param {Browser} browser
 * @param {string} address
 * @param {string[]} photos
 * @returns the 95th of a hundred
 */
async function inTheFirstSeconds(browser, address, photos) {
  const { page } = await opened(browser, address, photos);
  const result = await hurried(page);
  await page.close();
  return result;
}

/**
 * Shuffles of a page that appeared just now.
 * @param {import('playwright-core').Page} page
 * @returns their number, and the 95th percentile in milliseconds
 */
export async function hurried(page) {
  const [start, times] = [performance.now(), /** @type {number[]} */ ([])];
  while (times.length < HURRIED && performance.now() - start < FIRST_SECONDS) {
    times.push(await shuffled(page));
    await page.waitForTimeout(FIRST_SECONDS / HURRIED - Math.min(200, times[times.length - 1]));
  }
  times.sort((a, b) => a - b);
  return { count: times.length, ms: times[Math.ceil(0.95 * times.length) - 1] };
}

/** @type {WeakMap<import('playwright-core').Page, import('playwright-core').ElementHandle | null>} */
const buttons = new WeakMap();

/**
 * Milliseconds until the page of the next shuffle is on the screen.
 * @param {import('playwright-core').Page} page
 * @returns {Promise<number>}
 */
export async function shuffled(page) {
  // A search by role takes more time in the page than the shuffle.
  if (!buttons.has(page))
    buttons.set(page, await page.getByRole('button', { name: 'Shuffle', exact: true }).elementHandle());
  const button = /** @type {import('playwright-core').ElementHandle<HTMLElement>} */ (buttons.get(page));
  return button.evaluate((one) => /** @type {any} */ (globalThis).watch.afterPressing(one));
}

/** Runs in the page before its own scripts: clocks that end when what the user waits for has been painted. */
export function watch() {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const idle = () => document.body.dataset.idle === 'true';
  const drawn = () => document.body.dataset.drawn === 'true';
  const sketched = () => document.body.dataset.sketched === 'true' || drawn();
  const painted = async (/** @type {() => boolean} */ done = idle) => {
    // The frame in which the work begins, the frames that it takes, and the frame that shows the result.
    await frame();
    while (!done()) await frame();
    await frame();
    return performance.now();
  };
  // On the window object, because scripts of WebDriver have another global object in Firefox.
  Object.assign(window, {
    watch: {
      afterChoosing: async () => {
        const start = await new Promise((resolve) => {
          document.addEventListener('change', () => resolve(performance.now()), { capture: true, once: true });
        });
        const [sketch, seen] = [painted(sketched), painted(drawn)];
        const firstPage = (await painted()) - start;
        return { firstPage, drawn: (await seen) - start, sketched: (await sketch) - start };
      },
      /**
       * Milliseconds until the frame that shows a change drawn on the main thread.
       * @param {HTMLSelectElement} select
       * @param {string} value
       */
      afterChange: async (select, value) => {
        const start = performance.now();
        select.value = value;
        select.dispatchEvent(new Event('change', { bubbles: true }));
        await frame();
        // Runs after the frame was painted.
        await new Promise((resolve) => setTimeout(resolve));
        return performance.now() - start;
      },
      /** @param {HTMLElement} button */
      afterPressing: async (button) => {
        const start = performance.now();
        button.click();
        return (await painted()) - start;
      },
    },
  });
}
