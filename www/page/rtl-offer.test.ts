import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { isLeftward, offerRtl } from './rtl-offer.ts';

function offered(language: string, { rtl = false, past = 0 } = {}) {
  const page = signal(null as unknown);
  const sketch = signal(true);
  const store = {
    page,
    sketch,
    project: signal({ settings: { rtl } }),
    canUndo: signal(past > 0),
  };
  const notes: { text: string; run: () => void }[] = [];
  const changes: unknown[] = [];
  offerRtl({
    store: store as never,
    pages: { changeSettings: (wish: unknown) => void changes.push(wish) } as never,
    messages: { note: (text: string, { run }: { run: () => void }) => void notes.push({ text, run }) } as never,
    language,
  });
  return { page, sketch, notes, changes };
}

test('languages from right to left are offered pages from right to left, once, with the first page', () => {
  const { page, sketch, notes, changes } = offered('he-IL');
  page.value = {};
  expect(notes).toEqual([]);
  sketch.value = false;
  expect(notes.map(({ text }) => text)).toEqual(['Your language is read from right to left.']);
  page.value = {};
  expect(notes).toHaveLength(1);
  notes[0].run();
  expect(changes).toEqual([{ rtl: true }]);
});

test('other languages, Japanese, and projects that have a direction get no offer', () => {
  for (const { page, sketch, notes } of [
    offered('ja'),
    offered('en-US'),
    offered('ar', { rtl: true }),
    offered('ar', { past: 1 }),
  ]) {
    sketch.value = false;
    page.value = {};
    expect(notes).toEqual([]);
  }
  expect([isLeftward('AR-eg'), isLeftward('fa'), isLeftward('art'), isLeftward('')]).toEqual([
    true,
    true,
    false,
    false,
  ]);
});
