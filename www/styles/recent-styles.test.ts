import { expect, test } from 'vitest';
import { createRecentStyles } from './recent-styles.ts';

function box(text: string | null = null) {
  let kept = text;
  return {
    getItem: () => kept,
    setItem: (_: string, value: string) => {
      kept = value;
    },
  };
}

test('the style that was chosen last is the first, each once, and no more than six', () => {
  const storage = box();
  const recent = createRecentStyles(() => storage);
  for (const id of ['a', 'b', 'a', 'c', 'd', 'e', 'f', 'g']) recent.add(id);
  expect(recent.ids.value).toEqual(['g', 'f', 'e', 'd', 'c', 'a']);
  expect(createRecentStyles(() => storage).ids.value).toEqual(recent.ids.value);
});

test('what is in the storage is not trusted', () => {
  for (const text of ['{', '{}', 'null', '[1, "a", null]'])
    expect(createRecentStyles(() => box(text)).ids.value).toEqual(text.includes('"a"') ? ['a'] : []);
});

test('refused storage is no fault', () => {
  const recent = createRecentStyles(() => {
    throw new Error('refused');
  });
  recent.add('a');
  expect(recent.ids.value).toEqual(['a']);
});
