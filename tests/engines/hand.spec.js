// @ts-check
/** A phone in landscape, and messages during work, in every engine. */

import { covered } from '../web/covered.js';
import { expect, given, test } from './hands.js';

const DESK = { width: 1280, height: 700 };
const SIDEWAYS = { width: 844, height: 390 };

test('a phone held sideways shows a page of 200 pixels and more', async ({ person }) => {
  await person.begin();
  await person.resize(SIDEWAYS);
  const width = () => person.inPage(() => document.querySelector('.page-canvas')?.getBoundingClientRect().width);
  await expect.poll(width).toBeGreaterThanOrEqual(200);
});

test('what is said lies over the middle of no control', async ({ person }) => {
  await person.begin();
  await person.choose([given('photos/PROVENANCE.md')]);
  await expect
    .poll(() => person.inPage(() => document.querySelector('[role=alert]')?.textContent))
    .toContain('PROVENANCE.md');
  for (const size of [DESK, SIDEWAYS]) {
    await person.resize(size);
    await expect.poll(() => person.inPage(covered)).toEqual([]);
  }
});
