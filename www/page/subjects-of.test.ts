import { expect, it } from 'vitest';
import { signal } from '@preact/signals';
import { subjectsOf } from './subjects-of.ts';

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

it('is nothing for styles that draw the whole picture, and for no page', () => {
  expect(subjectsOf(store({ a: 'mask', b: 'mask' }), page('noir'))).toBe('');
  expect(subjectsOf(store({}), null)).toBe('');
});
