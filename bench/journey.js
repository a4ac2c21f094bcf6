// @ts-check
/** What a person waits for, in the real built site: the first page, a shuffle, the file. */

/** @typedef {import('playwright-core').Browser} Browser */

const SHUFFLES = 15;
const RESIZES = 8;

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ firstPage: number, refined: number, closer: number, shuffle: number, png: number, thumbnails: number, listed: number }>} milliseconds;
 *   `refined` from the first page until all photos are searched, `closer` until the small faces are looked for, too
 */
export async function journey(browser, address, photos) {
  const page = await browser.newPage({
    viewport: { width: 1920, height: 1080 },
    serviceWorkers: 'block',
    acceptDownloads: true,
  });
  await page.addInitScript(watch);
  await page.goto(address);
  const input = page.getByLabel('Photos or video');
  await input.waitFor({ state: 'attached' });
  const first = page.evaluate(() => /** @type {any} */ (globalThis).watch.afterChoosing());
  await input.setInputFiles(photos);
  const firstPage = await first;
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
  for (let i = 0; i < SHUFFLES; i += 1) {
    const shuffle = page.getByRole('button', { name: 'Shuffle', exact: true });
    times.push(await shuffle.evaluate((button) => /** @type {any} */ (globalThis).watch.afterPressing(button)));
  }
  const resizes = [];
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
  const listed = await page.getByRole('listbox', { name: 'Layouts' }).getByRole('option').count();
  const start = performance.now();
  const [download] = await Promise.all([
    page.waitForEvent('download', { timeout: 120_000 }),
    page.getByRole('button', { name: 'Download PNG', exact: true }).click(),
  ]);
  await download.path();
  const png = performance.now() - start;
  await page.close();
  const median = (/** @type {number[]} */ list) => list.sort((a, b) => a - b)[list.length >> 1];
  return { firstPage, refined, closer, shuffle: median(times), png, thumbnails: median(resizes), listed };
}

/** Runs in the page before its own scripts: clocks that end when what the user waits for has been painted. */
function watch() {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const idle = () => document.body.dataset.idle === 'true';
  const painted = async () => {
    // The frame in which the work begins, those that it takes, and the one that shows it.
    await frame();
    while (!idle()) await frame();
    await frame();
    return performance.now();
  };
  Object.assign(globalThis, {
    watch: {
      afterChoosing: async () => {
        const start = await new Promise((resolve) => {
          document.addEventListener('change', () => resolve(performance.now()), { capture: true, once: true });
        });
        return (await painted()) - start;
      },
      /**
       * Until the frame that shows what the change drew on this thread.
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
