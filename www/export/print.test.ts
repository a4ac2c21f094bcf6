import { expect, test } from 'vitest';
import { blanks, bled, COARSE, coarsePanels, enlarged, hasPlates, kept, NO_PRINT, pdfOptions } from './print.ts';

const page = (more: object = {}): any => ({
  layout: 'grid-2',
  style: 'riso',
  panels: [
    { photo: 'small', crop: { x: 0, y: 0, width: 0.5, height: 1 } },
    { photo: 'large', crop: null },
    { photo: null, crop: null },
  ],
  merges: [],
  page: { width: 2480, height: 3508, dpi: 300 },
  ...more,
});
const bounds = (x: number) => ({ bounds: { x, y: 0, width: 0.5, height: 0.5 } });
const geometry: any = { width: 1, height: 1.4, panels: [bounds(0), bounds(0.5), bounds(0)] };
const album: any = new Map([
  ['small', { meta: { width: 1000, height: 800 } }],
  ['large', { meta: { width: 6000, height: 4000 } }],
]);

test('a panel is coarse by what is shown of its photo, at the size on paper', () => {
  // 500 pixels over 4 inches.
  expect(coarsePanels(page(), geometry, album, 8)).toEqual([{ panel: 0, dpi: 125 }]);
  expect(coarsePanels(page(), geometry, album, 4)).toEqual([]);
  expect(COARSE).toBe(200);
});

test('merged panels are one picture, and a photo that is not there is none', () => {
  const merged = page({ merges: [[0, 1]] });
  expect(coarsePanels(merged, geometry, album, 8)).toEqual([{ panel: 0, dpi: 63 }]);
  const absent: any = new Map([['small', { meta: { width: 9, height: 9 }, absent: {} }]]);
  expect(coarsePanels(page(), geometry, absent, 8)).toEqual([]);
});

test('pages are enlarged where that is wanted, and kept without it', () => {
  const pages = [page()];
  expect(enlarged(pages, false)).toBe(pages);
  const [large] = enlarged(pages, true);
  expect(large.page).toEqual({ ...page().page, enlarge: true });
  expect(kept(large)).toEqual(page());
});

test('bleed is told in page widths, and never beyond what the core takes', () => {
  expect(bled(page(), 'mm3').page.bleed).toBeCloseTo(3 / 209.97, 4);
  expect(bled(page(), 'none')).toEqual(page());
  expect(bled(page({ page: { width: 64, height: 64, dpi: 300 } }), 'mm5').page.bleed).toBe(0.1);
});

test('paper is of sheets that pages share', () => {
  expect(pdfOptions({ ...NO_PRINT, paper: 'a4' })).toEqual({ marks: false, imposition: null, paper: null });
  expect(pdfOptions({ ...NO_PRINT, sheets: 'twoUp', paper: 'a4' })).toEqual({
    marks: false,
    imposition: '2up',
    paper: [210, 297],
  });
  expect([blanks('booklet', 5), blanks('zine', 8), blanks('twoUp', 3), blanks('spreads', 3)]).toEqual([3, 0, 1, 0]);
});

test('plates are of styles that print with inks', () => {
  const riso: any = { id: 'riso', background: [{ block: 'plates' }] };
  const off: any = { id: 'riso', background: [{ block: 'plates', bypass: true }] };
  const two = [page(), page()];
  expect([hasPlates(two, [riso]), hasPlates(two, [off]), hasPlates(two, [])]).toEqual([true, false, false]);
  expect(hasPlates([page({ style: riso })], [])).toBe(true);
  // Two styles may have other inks.
  expect(hasPlates([page(), page({ style: riso })], [riso])).toBe(false);
  expect(hasPlates([], [riso])).toBe(false);
});
