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
