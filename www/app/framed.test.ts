import { expect, test } from 'vitest';
import { isFramedByOthers } from './framed.ts';

/**
 * Nested windows, the outermost first.
 * @returns the innermost
 */
function windows(...origins: ('own' | 'other')[]): Window {
  let parent: any;
  for (const origin of origins) {
    const made = {
      get document() {
        if (origin === 'other') throw new DOMException('Blocked a frame', 'SecurityError');
        return {};
      },
    };
    parent = Object.assign(Object.create(null, Object.getOwnPropertyDescriptors(made)), { parent: parent ?? null });
    parent.parent ??= parent;
  }
  return parent;
}

test('a page is framed by others where any page around it is of another origin', () => {
  expect(isFramedByOthers(windows('own'))).toBe(false);
  expect(isFramedByOthers(windows('own', 'own'))).toBe(false);
  expect(isFramedByOthers(windows('own', 'own', 'own'))).toBe(false);
  expect(isFramedByOthers(windows('other', 'own'))).toBe(true);
  expect(isFramedByOthers(windows('other', 'own', 'own'))).toBe(true);
  expect(isFramedByOthers(windows('own', 'other', 'own'))).toBe(true);
});
