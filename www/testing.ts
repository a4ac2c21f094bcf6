import type {
  Browser,
  BrowserContext as Context,
  Page,
  PlaywrightTestArgs,
  PlaywrightTestOptions,
  PlaywrightWorkerArgs,
  PlaywrightWorkerOptions,
  TestType,
} from '@playwright/test';
import { createRequire } from 'node:module';

/**
 * The packages that the browser tests use. The tests are in `tests`, outside this folder's `node_modules`, and import
 * the packages through this file.
 */
export { defineConfig, expect, test } from '@playwright/test';
export type { Locator, TestInfo } from '@playwright/test';
export { Builder, Key, Origin } from 'selenium-webdriver';
export type { WebDriver, WebElement } from 'selenium-webdriver';
/** A script that finds elements by role and accessible name in any browser. */
export const QUERIES = createRequire(import.meta.url).resolve(
  '@testing-library/dom/dist/@testing-library/dom.umd.min.js',
);
export { default as AxeBuilder } from '@axe-core/playwright';
export { PNG } from 'pngjs';
/** TypeScript as the build makes it. */
export { transformWithOxc } from 'vite';
export type { Page };
export type { Browser };
export type { Context };
/** Tests with `Own` in addition to a page. */
export type TestWith<Own extends {}> = TestType<
  PlaywrightTestArgs & PlaywrightTestOptions & Own,
  PlaywrightWorkerArgs & PlaywrightWorkerOptions
>;
