// @ts-check
import { defineConfig } from 'vitest/config';
import { netsModule } from './nets-module.js';
import { siteFiles } from './site-files.js';
import { messages } from './strings/compile.js';

/**
 * Orders the head of the page for a fast first picture. The script of the theme comes last, because the browser loads nothing
 * below it until it has run. The pictures of the start screen have a higher priority than the app.
 * @returns {import('vite').Plugin}
 */
const fastStart = () => ({
  name: 'inkpanel-fast-start',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler(html) {
      const [theme] = html.match(/ *<script src="[^"]*theme\.js"><\/script>\n/) ?? [''];
      if (theme === '' || !html.includes('<script type="module"')) throw new Error('index.html has no theme or no app');
      return html
        .replace(theme, '')
        .replace('  </head>', `${theme}  </head>`)
        .replaceAll('<script type="module"', '<script type="module" fetchpriority="low"');
    },
  },
});

// `base: './'` makes every address relative, so the built site runs from any folder of any static host.
export default defineConfig({
  base: './',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  plugins: [messages(), netsModule(), fastStart(), siteFiles()],
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    // The polyfill is an inline script, which the page's Content-Security-Policy forbids.
    modulePreload: { polyfill: false },
    // The start screen loads one file of shared code instead of 35 small ones.
    rolldownOptions: { output: { codeSplitting: { groups: [{ name: 'index', tags: ['$initial'] }] } } },
  },
  worker: { format: 'es' },
  test: {
    // The machine may be busy: a limit ends what hangs, it does not measure.
    testTimeout: 60_000,
    include: ['**/*.test.ts', '*.test.js'],
  },
});
