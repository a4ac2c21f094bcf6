// @ts-check
/** The real page with photos in it, at rest. */

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 */
export async function opened(browser, address, photos) {
  const page = await browser.newPage({ viewport: { width: 1920, height: 1080 }, serviceWorkers: 'block' });
  await page.addInitScript(() => localStorage.setItem('inkpanel.detect', 'off'));
  await page.goto(address);
  const input = page.getByLabel('Photos or video');
  await input.waitFor({ state: 'attached' });
  await input.setInputFiles(photos);
  await page.waitForFunction(
    () => document.body.dataset.idle === 'true' && document.querySelector('.page-canvas') !== null,
  );
  return page;
}
