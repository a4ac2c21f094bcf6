// @ts-check
import { signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { createStyling } from './styling.js';
import { fakeApp } from './testing.js';

const style = (/** @type {string} */ id) => ({ id, name: id, tags: [], background: [] });

it('draws from one’s own styles and favourites, each once, only where a style is drawn', async () => {
  const { store, planner, pages, reading, files } = fakeApp();
  const ownStyles = { mine: signal([style('a'), style('b')]), favourites: signal([style('b'), style('c')]) };
  const styling = createStyling(/** @type {any} */ ({ store, ownStyles }));
  store.planner.value = styling.within(/** @type {any} */ (planner));
  await reading.addFiles(files('1', '2', '3'));
  styling.change({ invented: 0.4, keepLines: true });
  pages.shuffle('style');
  const told = planner.requests.at(-1)?.styling;
  expect(told).toMatchObject({ invented: 0.4, keepLines: true, keepColours: false });
  expect(told?.extra.map((/** @type {any} */ { id }) => id)).toEqual(['a', 'b', 'c']);
  pages.shuffle('layout');
  expect(planner.requests.at(-1)?.styling).toBe(undefined);
  pages.undo();
  pages.undo();
  pages.undo();
  expect(store.project.value.styling).toEqual({ invented: 0, keepLines: false, keepColours: false });
});
