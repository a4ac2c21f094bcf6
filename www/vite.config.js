// @ts-check
import { defineConfig } from 'vitest/config';
import { netsModule } from './nets-module.js';
import { siteFiles } from './site-files.js';
import { messages } from './strings/compile.js';

// `base: './'` makes every address relative, so the built site runs from any folder of any static host.
export default defineConfig({
  base: './',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  plugins: [messages(), netsModule(), siteFiles()],
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    // The polyfill is an inline script, which the page's Content-Security-Policy forbids.
    modulePreload: { polyfill: false },
  },
  worker: { format: 'es' },
  test: {
    // The machine may be busy: a limit ends what hangs, it does not measure.
    testTimeout: 60_000,
    include: ['**/*.test.ts', '*.test.js'],
  },
});
