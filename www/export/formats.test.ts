import { expect, test } from 'vitest';
import { pageName } from './formats.ts';

test('pages of an archive stand in their order', () => {
  expect(pageName(0, 3, 'png')).toBe('page-01.png');
  expect(pageName(9, 120, 'jpeg')).toBe('page-010.jpg');
});
