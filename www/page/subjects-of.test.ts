import { expect, it } from 'vitest';
import { signal } from '@preact/signals';
import { subjectOf, subjectsOf } from './subjects-of.ts';

const plain = { id: 'noir', background: [{ block: 'to_gray' }] };
const parted = { id: 'silhouette', background: [{ block: 'to_gray', where: 'subject' }] };
const page = (style: string | object) => ({ style, panels: [{ photo: 'a' }, { photo: null }, { photo: 'b' }] }) as any;
const store = (masks: Record<string, string | undefined>) =>
  ({
    styles: signal([plain, parted]),
    masks: signal(new Map(Object.entries(masks))),
  }) as any;

it('is another text once a mask is there, for styles that draw parts apart', () => {
  const before = subjectsOf(store({ a: undefined, b: undefined }), page('silhouette'));
  const after = subjectsOf(store({ a: undefined, b: 'mask' }), page('silhouette'));
  expect(after).not.toBe(before);
  expect(subjectsOf(store({ b: 'mask' }), page(parted))).toBe(after);
});

it('is another text once a mask is there that an effect stands behind', () => {
  const words = [{ kind: 'effect', panel: 2, behind: true }];
  const lettered = { ...page('noir'), words, merges: [] };
  expect(subjectsOf(store({ b: 'mask' }), lettered)).not.toBe(subjectsOf(store({}), lettered));
  const held = { ...store({ b: 'mask' }), page: signal(lettered) };
  expect([0, 2, undefined].map((panel) => subjectOf(held, { panel } as any))).toEqual(['', 'mask', '']);
});

it('is nothing for styles that draw the whole picture, and for no page', () => {
  expect(subjectsOf(store({ a: 'mask', b: 'mask' }), page('noir'))).toBe('');
  expect(subjectsOf(store({}), null)).toBe('');
});
