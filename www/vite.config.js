// @ts-check
import { defineConfig } from 'vitest/config';
import { siteFiles } from './site-files.js';

/** The modules all have one file name; the detectors' is told apart, as it is kept in another way. */
const output = {
  assetFileNames: (/** @type {{ originalFileNames: string[] }} */ { originalFileNames: [path = ''] }) => (
    path.includes('pkg-detector') ? 'assets/detector-[hash][extname]' : 'assets/[name]-[hash][extname]'
  ),
};

// `base: './'` makes every address relative, so the built site runs from any folder of any static host.
export default defineConfig({
  base: './',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  plugins: [siteFiles()],
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    // The polyfill is an inline script, which the page's Content-Security-Policy forbids.
    modulePreload: { polyfill: false },
    rolldownOptions: { output },
  },
  worker: { format: 'es', rolldownOptions: { output } },
  test: {
    include: ['state/**/*.test.js', 'engine/**/*.test.js', 'views/**/*.test.js', 'service-worker/**/*.test.js', 'strings/**/*.test.js'],
  },
});
