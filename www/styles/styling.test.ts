import { signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { createStyling } from './styling.ts';
import { fakeApp } from '../document/testing.ts';
import type { Wish } from '../engine/core.ts';

const style = (id: string) => ({ id, name: id, tags: [], background: [] });

it('draws from one’s own styles and favourites, each once, only where a style is drawn', async () => {
  const asked = (wish: Wish) => styling.asked(wish);
  const { store, planner, pages, reading, files } = fakeApp({}, { asked });
  const ownStyles = { mine: signal([style('a'), style('b')]), favourites: signal([style('b'), style('c')]) };
  const styling = createStyling({ store, ownStyles, inventions: () => [style('tried')] } as any);
  await reading.addFiles(files('1', '2', '3'));
  styling.change({ invented: 0.4, keepLines: true });
  pages.shuffle('style');
  const told = planner.wishes.at(-1)?.draw.styling;
  expect(told).toMatchObject({ invented: 0.4, keepLines: true, keepColours: false });
  expect(told?.extra?.map(({ id }: { id: string }) => id)).toEqual(['a', 'b', 'c']);
  expect(told?.inventions?.map(({ id }: { id: string }) => id)).toEqual(['tried']);
  pages.shuffle('layout');
  expect(planner.wishes.at(-1)?.draw.styling).toBe(undefined);
  pages.undo();
  pages.undo();
  pages.undo();
  expect(store.project.value.styling).toEqual({ invented: 0.15, keepLines: false, keepColours: false });
});
