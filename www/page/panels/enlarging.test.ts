import { expect, test } from 'vitest';
import { unreadMeta } from '../../document/album.ts';
import { core } from '../../engine/testing-core.ts';
import { enlarged } from './enlarging.ts';
import type { PageDocument } from '../../engine/types.ts';

const paper = { width: 2480, height: 3508 };
const use = { photo: null, crop: null, locked: false, edited: false };
const settings = core.plan({
  seed: 1,
  photos: [unreadMeta('a')],
  page: paper as any,
  current: null,
  keep: { layout: false, style: false, photos: false },
}).page;

function pageOf(layout: string, more: Partial<PageDocument> = {}): PageDocument {
  const { count } = core.layoutFacts(layout, settings);
  return { layout, page: settings, merges: [], panels: Array.from({ length: count }, () => use), ...more } as any;
}

const areas = (page: PageDocument) =>
  core.geometry(page.layout, settings).panels.map(({ bounds }) => bounds.width * bounds.height);

const grid = core
  .listLayouts({ page: paper, own: [] })
  .find(({ id, count }) => count === 4 && core.layoutFacts(id, settings).cuts.length >= 3)?.id as string;

test.each([0, 1, 2, 3])('the panel %i becomes larger, and the other panels keep a fair size', (panel) => {
  const before = pageOf(grid);
  const after = pageOf(grid, { layout: enlarged(core, before, panel) as any });
  const [small, large] = [areas(before), areas(after)];
  expect(large[panel]).toBeGreaterThan(1.2 * small[panel]);
  for (const [i, area] of large.entries()) if (i !== panel) expect(area).toBeGreaterThan(0.49 * small[i]);
});

test('an inset grows inside the margins up to a part of the page, and the other panels stay as they are', () => {
  const { id, count } = core
    .listLayouts({ page: paper as any, own: [] })
    .find((layout) => core.layoutFacts(layout.id, settings).base < layout.count) as any;
  const inset = count - 1;
  let page = pageOf(id);
  expect(core.geometry(id, settings).panels[inset].overlay).toBe(true);
  const before = areas(page);
  for (let i = 0; i < 8; i += 1) page = { ...page, layout: enlarged(core, page, inset) ?? page.layout };
  const after = areas(page);
  expect(after[inset]).toBeGreaterThan(1.2 * before[inset]);
  expect(after[inset]).toBeLessThan(0.31 * (paper.height / paper.width));
  expect(after.slice(0, inset)).toEqual(before.slice(0, inset));
  expect(enlarged(core, page, inset)).toBe(null);
});

test('a locked panel keeps its size, and a layout without cuts stays as it is', () => {
  const panels = Array.from({ length: 4 }, (_, i) => ({ ...use, locked: i > 0 }));
  expect(enlarged(core, pageOf(grid, { panels }), 0)).toBe(null);
  expect(enlarged(core, pageOf('mosaic-y'), 0)).toBe(null);
});
