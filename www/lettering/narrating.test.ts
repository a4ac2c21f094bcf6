import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { createNarrating } from './narrating.ts';

test('text moves off faces that are detected later, but not text that the user moved', () => {
  const words = [
    { kind: 'balloon', text: 'placed', auto: true, x: 0.5, y: 0.5 },
    { kind: 'caption', text: 'made', auto: true, made: true, x: 0.1, y: 0.1 },
    { kind: 'balloon', text: 'moved', auto: false, x: 0.5, y: 0.5 },
  ];
  const changes: any[] = [];
  const store: any = {
    page: signal({ words }),
    project: signal({ at: 2 }),
    change: (change: object) => changes.push(change),
  };
  const settled = (page: any, only: readonly number[]) => ({
    ...page,
    words: page.words.map((word: object, i: number) => (only.includes(i) ? { ...word, y: 0.9 } : word)),
  });
  const album = { title: () => '', moments: () => new Map() };
  createNarrating({ store, ui: {} as any, album, settled }).avoidFaces();
  expect(changes).toHaveLength(1);
  expect(changes[0]).toMatchObject({ type: 'set-words', silent: true });
  expect(changes[0].pages[0]).toMatchObject({ at: 2, words: [{ y: 0.9 }, { y: 0.9 }, { y: 0.5 }] });
});
