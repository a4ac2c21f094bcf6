import { expect, test } from 'vitest';
import { escapeOf } from './escape.ts';
import { fakeParts } from './app-testing.ts';

const parts = await fakeParts();
const { ui, explorer, shownPages } = parts;

/** Presses Escape. */
function leave() {
  escapeOf(parts)?.();
}

test('Escape cancels a combination of styles, and then closes the explorer', () => {
  ui.work.value = 'explorer';
  explorer.parent.value = { id: 'mine', name: 'Mine' } as any;
  leave();
  expect([explorer.parent.value, ui.work.value]).toEqual([null, 'explorer']);
  leave();
  expect(ui.work.value).toBe(null);
});

test('Escape ends the comparison of versions, and then closes the page history', () => {
  ui.work.value = 'pages';
  shownPages.pair.value = [3];
  leave();
  expect([shownPages.pair.value, ui.work.value]).toEqual([[], 'pages']);
  leave();
  expect(ui.work.value).toBe(null);
});
