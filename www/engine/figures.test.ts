import { expect, it } from 'vitest';
import {
  byPanel,
  drawnWith,
  frontPictures,
  frontsOf,
  paintOrder,
  panelOf,
  picturesOf,
  standsBehind,
} from './figures.ts';
import type { PageDocument, Word } from './types.ts';

const word = (kind: string, more: Partial<Word> = {}) => ({ kind, text: 'x', panel: 1, ...more }) as Word;

/** A page of three panels; the last one has a breakout. */
function paged(...words: Word[]): PageDocument {
  const panel = (photo: string, figure?: string) => ({ photo, figure });
  return { panels: [panel('a'), panel('b'), panel('c', '1x1:p')], merges: [], words } as unknown as PageDocument;
}

it('numbers fronts on from panels and figures, each panel once', () => {
  const behind = word('effect', { behind: true });
  const page = paged(behind, behind, word('effect', { behind: true, panel: 0 }));
  expect(picturesOf(page)).toEqual([0, 1, 2, 3]);
  expect(frontsOf(page)).toEqual([0, 1]);
  expect(frontPictures(page)).toEqual([4, 5]);
  expect([3, 4, 5].map((picture) => panelOf(page, picture))).toEqual([2, 0, 1]);
  expect(byPanel(page, [0, 1, 2, 3, 4, 5])).toEqual([
    [0, 4],
    [1, 5],
    [2, 3],
  ]);
});

it('draws a panel with the figure that steps out of it', () => {
  expect([0, 2, 3].map((picture) => drawnWith(paged(), picture))).toEqual([[0], [2, 3], [2, 3]]);
  expect(drawnWith({ ...paged(), merges: [[1, 2]] }, 2)).toEqual([2]);
});

it.each([
  ['a caption', word('caption', { behind: true })],
  ['an effect in front', word('effect')],
  ['an effect on the page itself', word('effect', { behind: true, panel: undefined })],
  ['an effect on a panel that is gone', word('effect', { behind: true, panel: 7 })],
])('%s has no front', (_, one) => {
  expect(frontsOf(paged(one))).toEqual([]);
  expect(paintOrder(paged(one, word('caption')))).toEqual([0, 1]);
});

it('draws what stands behind a figure before all other words, each lot in its order', () => {
  const behind = word('effect', { behind: true });
  expect(standsBehind(behind)).toBe(1);
  expect(paintOrder(paged(word('balloon'), behind, word('effect'), behind))).toEqual([1, 3, 0, 2]);
});
