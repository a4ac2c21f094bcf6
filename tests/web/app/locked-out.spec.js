// @ts-check
/** Whatever lies in the database: the page starts, `Projects` opens, and a project that cannot be shown has ways on. */

import { readFile } from 'node:fs/promises';
import { SIX, accessible, contents, expect, idle, openBoard, press, test } from './support.js';
import { backUp, leave, spoil } from './table-hands.js';

/** @typedef {import('./support.js').Page} Page */
/** @typedef {import('./table-hands.js').Table} Table */

const saved = (/** @type {Page} */ page) => expect(page.locator('.save-state')).toHaveText('Saved');
const broken = (/** @type {Page} */ page) => page.getByRole('group', { name: /cannot be shown/ });

/** A project of two pages, drawn and saved, and a copy of the tables. @param {Page} page */
async function trip(page) {
  await openBoard(page, SIX.slice(0, 3));
  await page.getByLabel('Project name').fill('Trip');
  await page.keyboard.press('Enter');
  await saved(page);
  await press(page, 'Shuffle');
  await saved(page);
  // What was drawn is written with the next saving, and the one before may have come before the drawing.
  await press(page, 'Lock style');
  await saved(page);
  const shown = await contents(page);
  await leave(page);
  await backUp(page);
  return shown;
}

const present = (/** @type {string} */ fields) =>
  `({ ...record, history: { ...record.history, present: { ...record.history.present, ${fields} } } })`;
const onPage = (/** @type {string} */ fields) => present(`page: { ...record.history.present.page, ${fields} }`);

/** What of a state locks nobody out any more: each was saved by a page that could not open it again. @type {Record<string, string>} */
const LOCKS = {
  'settings without a width': present('settings: { ...record.history.present.settings, width: null }'),
  'a merge of nothing': onPage('merges: [null]'),
  'a number for a text': onPage("words: [{ kind: 'caption', text: 5, panel: 0 }]"),
  'a thousand words': onPage("words: Array(1000).fill({ kind: 'caption', text: 'MORE', panel: 0 })"),
  'photos alike by halves': present('alike: 10.5'),
};

/** @type {[Table, string, string][]} */
const GARBAGE = [
  ...Object.entries(LOCKS).map(([name, change]) => /** @type {[Table, string, string]} */ (['states', name, change])),
  ['states', 'nothing', '({ id: record.id })'],
  ['states', 'gone', 'undefined'],
  ['states', 'no history', '({ ...record, history: null })'],
  ['states', 'a history of text', "({ ...record, history: 'once upon a time' })"],
  ['states', 'no version', '({ ...record, version: undefined })'],
  ['states', 'a newer version', '({ ...record, version: 99 })'],
  ['states', 'no present', '({ ...record, history: { ...record.history, present: 7 } })'],
  ['states', 'a present of bytes', '({ ...record, history: { ...record.history, present: new Uint8Array(9) } })'],
  [
    'states',
    'a circle',
    '(() => { const round = { ...record }; round.history = { past: [round], present: round, future: [], shown: [] }; return round; })()',
  ],
  ['states', 'a tray of holes', present('tray: [null, 5]')],
  ['states', 'a page of panels of nothing', onPage('panels: [null, null]')],
  ['states', 'an unknown layout', onPage("layout: 'no such layout'")],
  ['states', 'an unknown style', onPage("style: { block: 'none' }")],
  ['states', 'a big integer', present('alike: 10n')],
  ['states', 'videos and facts of another kind', '({ ...record, facts: 5, videos: [null, { key: 1 }] })'],
  ['projects', 'nothing', '({ id: record.id })'],
  ['projects', 'gone', 'undefined'],
  [
    'projects',
    'another kind of everything',
    "({ id: record.id, name: 5, created: 'x', changed: {}, stamp: {}, photos: null, picture: 'none', refs: 7, gone: null })",
  ],
  ['projects', 'a time that is none', '({ ...record, changed: NaN, created: 1e300 })'],
  ['facts', 'nothing', '({ id: record.id })'],
  ['facts', 'gone', 'undefined'],
  [
    'facts',
    'a photo without sides',
    '({ ...record, fact: { ...record.fact, meta: { ...record.fact.meta, width: 0 } } })',
  ],
  ['facts', 'a name that is none', '({ ...record, fact: { ...record.fact, name: 5 } })'],
  ['photos', 'nothing', '({ id: record.id })'],
  ['photos', 'gone', 'undefined'],
  ['photos', 'another kind of everything', "({ id: record.id, name: 5, file: 'x', work: 7, small: [] })"],
  ['photos', 'copies without planes', '({ ...record, work: { key: 1 }, small: {} })'],
];

test('whatever the database holds the page starts and lists its projects', async ({ page }) => {
  await trip(page);
  for (const [table, what, change] of GARBAGE) {
    await test.step(`${table}: ${what}`, async () => {
      await leave(page);
      await spoil(page, table, change);
      await page.goto('./');
      await idle(page);
      const start = page.getByRole('button', { name: 'Choose photos or a video' });
      const board = page.getByRole('region', { name: 'Comic page' });
      await expect(start.or(board)).toBeVisible();
      if (await board.isVisible()) await saved(page);
      await page.getByRole('button', { name: 'Projects' }).click();
      await expect(page.getByRole('region', { name: 'Projects' }).getByRole('listitem')).not.toHaveCount(0);
    });
  }
});

test('a project that cannot be shown goes back to the last state that was drawn', async ({ page }) => {
  const shown = await trip(page);
  for (const [what, change] of Object.entries(LOCKS)) {
    await test.step(what, async () => {
      await leave(page);
      await spoil(page, 'states', change);
      await page.goto('./');
      await idle(page);
      const why = what === 'a thousand words' ? 'it exceeds the limits of a project' : 'part of it is damaged';
      await expect(broken(page)).toContainText(`Trip cannot be shown: ${why}.`);
      if (what === 'a merge of nothing') await accessible(page);
      await broken(page).getByRole('button', { name: 'Restore the last good version' }).click();
      await expect(page.getByRole('status').getByText('The last good version of Trip was restored.')).toBeVisible();
      await idle(page);
      expect(await contents(page)).toEqual(shown);
      await saved(page);
      await page.reload();
      await idle(page);
      expect(await contents(page)).toEqual(shown);
      await expect(broken(page)).toHaveCount(0);
    });
  }
});

test('a project that cannot be shown is saved as a file, and another is opened', async ({ page }) => {
  await trip(page);
  await spoil(page, 'states', "({ id: record.id, version: 1, history: 'lost', facts: record.facts })");
  await page.goto('./');
  await idle(page);
  const download = page.waitForEvent('download');
  await broken(page).getByRole('button', { name: 'Save as file' }).click();
  const file = await (await download).path();
  const bytes = await readFile(file);
  for (const name of ['project.json', ...SIX.slice(0, 3)]) expect(bytes.includes(name), name).toBe(true);
  // A new one is begun beside it.
  await broken(page).getByRole('button', { name: 'Open another' }).click();
  const projects = page.getByRole('region', { name: 'Projects' });
  await expect(broken(page)).toBeVisible();
  await accessible(page);
  await expect(projects.getByRole('button', { name: 'Open Trip' })).toBeVisible();
  await page.getByRole('button', { name: 'Back to the page' }).click();
  await page.getByRole('button', { name: 'Try the sample album' }).click();
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await saved(page);
  // It is opened in vain, and what is on the page stays.
  const before = await contents(page);
  await page.getByRole('button', { name: 'Projects' }).click();
  await projects.getByRole('button', { name: 'Open Trip' }).click();
  await expect(broken(page)).toBeVisible();
  await page.getByRole('button', { name: 'Back to the page' }).click();
  expect(await contents(page)).toEqual(before);
  await page.reload();
  await idle(page);
  expect(await contents(page)).toEqual(before);
});
