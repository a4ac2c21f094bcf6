import { expect, test } from 'vitest';
import { fileName, pageName, panelName } from './formats.ts';

const page = { layout: 'grid-6', style: { id: 'mine' }, seed: 7 } as any;

test('files are called after what they show', () => {
  expect(fileName([page], 'png')).toBe('inkpanel-grid-6-mine-7.png');
  expect(fileName([page], 'jpeg')).toBe('inkpanel-grid-6-mine-7.jpg');
  expect(fileName([{ ...page, style: {} }], 'pdf')).toBe('inkpanel-grid-6-own-7.pdf');
  expect(fileName([page, page, page], 'cbz')).toBe('inkpanel-3-pages.cbz');
  expect(panelName(page, 1)).toBe('inkpanel-grid-6-mine-7-panel-2.png');
});

test('pages of an archive stand in their order', () => {
  expect(pageName(0, 3, 'png')).toBe('page-01.png');
  expect(pageName(9, 120, 'jpeg')).toBe('page-010.jpg');
});
