// @ts-check
/**
 * The packages that the browser tests use. The tests stand in `tests/web`, outside this folder's
 * `node_modules`, and reach them through this file.
 */
export { expect, test } from '@playwright/test';
export { default as AxeBuilder } from '@axe-core/playwright';
export { PNG } from 'pngjs';
/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('@playwright/test').Browser} Browser */
/** @typedef {import('@playwright/test').BrowserContext} Context */
/**
 * Tests that are given `Own` beside a page.
 * @template {{}} Own
 * @typedef {import('@playwright/test').TestType<
 *   import('@playwright/test').PlaywrightTestArgs & import('@playwright/test').PlaywrightTestOptions & Own,
 *   import('@playwright/test').PlaywrightWorkerArgs & import('@playwright/test').PlaywrightWorkerOptions
 * >} TestWith
 */
