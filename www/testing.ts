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
/**
 * The packages that the browser tests use. The tests stand in `tests/web`, outside this folder's
 * `node_modules`, and reach them through this file.
 */
export { expect, test } from '@playwright/test';
export { default as AxeBuilder } from '@axe-core/playwright';
export { PNG } from 'pngjs';
/** TypeScript as the build makes it. */
export { transformWithOxc } from 'vite';
export type { Page };
export type { Browser };
export type { Context };
/** Tests that are given `Own` beside a page. */
export type TestWith<Own extends {}> = TestType<
  PlaywrightTestArgs & PlaywrightTestOptions & Own,
  PlaywrightWorkerArgs & PlaywrightWorkerOptions
>;
