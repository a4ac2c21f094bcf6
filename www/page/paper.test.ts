import { expect, test } from 'vitest';
import { DEFAULT_SETTINGS } from '../document/empty.ts';
import { unreadMeta } from '../document/album.ts';
import { core } from '../engine/testing-core.ts';
import { DARK_PAPER } from './paper.ts';

test('a dark style gets the dark paper', () => {
  const plans = core.createEditor().plans([unreadMeta('a')]);
  const styled = (style: string) =>
    plans.page({ keep: { layout: false, style: false, photos: false }, page: DEFAULT_SETTINGS, style, seed: 1 });
  expect(styled('moonlight')?.page).toMatchObject(DARK_PAPER);
  expect(styled('comic')?.page).toEqual(DEFAULT_SETTINGS);
});
