import { expect, test } from 'vitest';
import { fileName, panelName } from './export-name.ts';

const alone = { name: 'Summer in Lisbon', at: 0, others: [] };
const second = { name: 'Summer in Lisbon', at: 1, others: [{}, {}] as any };

test('files are called after the project, and after the page where there are several', () => {
  expect(fileName(alone, 1, 'png')).toBe('Summer in Lisbon.png');
  expect(fileName(second, 1, 'jpeg')).toBe('Summer in Lisbon - page 2.jpg');
  expect(fileName(second, 3, 'cbz')).toBe('Summer in Lisbon.cbz');
  expect(fileName(second, 3, 'pdf', true)).toBe('Summer in Lisbon - print.pdf');
  expect(fileName(second, 1, 'zip', true)).toBe('Summer in Lisbon - page 2 - print.zip');
  expect(fileName({ ...alone, name: '' }, 1, 'pdf')).toBe('Untitled.pdf');
});

test('a panel has its number', () => {
  expect(panelName(alone, 1)).toBe('Summer in Lisbon - panel 2.png');
  expect(panelName(second, 0)).toBe('Summer in Lisbon - page 2 - panel 1.png');
});
