// @ts-check
import { defineConfig } from '@playwright/test';
import { CHROMIUM, servedSite } from '../tests/web/launching.js';

const site = servedSite(4187);

/** Specs that take more than half a minute. */
const LONG = /\/(explorer|explorer-wall|languages|malformed-files|masks|screens|subject-brush)\.spec\.js$/;

/** The tests of a change leave these specs out: specs of rare events, and slow specs. */
const RARE = [
  'animatic',
  'broken-projects',
  'content-security-policy',
  'dropped-projects',
  'explorer-wall',
  'framed',
  'help',
  'hints',
  'html-comic',
  'hung-workers',
  'killed-tab',
  'language-and-theme',
  'languages',
  'long-press',
  'look-alikes',
  'lost-photos',
  'malformed-files',
  'masks',
  'missing-modules',
  'motion-comic',
  'multiple-pages',
  'offline',
  'print-resolution',
  'project-in-png',
  'rejected-files',
  'reload',
  'saving',
  'scores',
  'screens',
  'sounds',
  'start-times',
  'style-files',
  'style-from-picture',
  'subject-brush',
  'touch',
  'traps',
  'unreadable-files',
  'unusual-videos',
  'update',
  'video',
  'zoom',
];

/** Tags of the tests that a tier of `cargo xtask test` leaves out. A manual run uses the tier `ci`. */
const LEFT_OUT = { change: /@ci|@nightly/, ci: /@nightly/, all: undefined };
const tier = /** @type {keyof typeof LEFT_OUT} */ (process.env.INKPANEL_TIER ?? 'ci');
if (!(tier in LEFT_OUT))
  throw new Error(`INKPANEL_TIER: ${tier} is not a tier; use ${Object.keys(LEFT_OUT).join(', ')}`);
const ignored = tier === 'change' ? [new RegExp(`/(${RARE.join('|')})\\.spec\\.js$`)] : [];
if (ignored.length > 0 && !process.env.TEST_WORKER_INDEX)
  console.log(`Left out, run by \`cargo xtask test --ci\`: ${RARE.join(', ')}, and tests with the tag @ci`);

export default defineConfig({
  testDir: '../tests/web/app',
  outputDir: '../tests/web/results',
  fullyParallel: false,
  grepInvert: LEFT_OUT[tier],
  // Files start in the order of the projects. A long file that starts late would run alone at the end.
  projects: [
    { name: 'long', testMatch: LONG, testIgnore: ignored },
    { name: 'short', testIgnore: [LONG, ...ignored] },
  ],
  // A page that waits for a timer, a message or a worker leaves cores idle: two files run in parallel, even on two cores.
  workers: 2,
  // The machine may be busy. The time limit ends hanging tests. It measures nothing.
  timeout: 240_000,
  expect: { timeout: 30_000 },
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: {
    baseURL: site.url,
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    // Responses of a service worker cannot be changed by a test. `offline.spec.js` allows it.
    serviceWorkers: 'block',
    // Screenshots and snapshots of every step take a third of the time of the tests.
    trace: { mode: 'retain-on-failure', screenshots: false, snapshots: false, sources: false },
    screenshot: 'only-on-failure',
    launchOptions: CHROMIUM,
  },
  webServer: site.webServer,
});
