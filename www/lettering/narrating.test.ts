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

test('place names are turned on and off in the captions of all pages, except those of a book', () => {
  const made = (text: string, more = {}) => ({ kind: 'caption', text, auto: true, made: true, ...more });
  const [first, second] = ['a', 'b'].map((photo) => ({ panels: [{ photo }] }));
  const pages: any[] = [
    { ...first, words: [made('Sintra', { located: true })] },
    { ...second, words: [made('Sintra', { located: true, book: true })] },
    { ...second, words: [made('Sintra', { located: true }), { kind: 'balloon', text: 'Mine' }] },
    { ...first, words: [{ kind: 'balloon', text: 'Mine' }] },
  ];
  const project: any = {
    at: 0,
    page: pages[0],
    others: pages.slice(1).map((page, i) => ({ page, pageId: i, sheet: i })),
  };
  const changes: any[] = [];
  const store: any = {
    project: signal(project),
    page: signal(pages[0]),
    change: (change: object) => changes.push(change),
  };
  let shown = true;
  const ui: any = { narrates: signal(true), showPlaces: (on: boolean) => (shown = on) };
  const moments = () => new Map([['a', { at: null, place: shown ? 'Sintra' : '' }]]);
  const narrating = createNarrating({ store, ui, album: { title: () => '', moments }, settled: (page) => page });
  narrating.turnPlaces(false);
  expect(changes).toEqual([
    {
      type: 'set-words',
      pages: [
        { at: 0, words: [] },
        { at: 2, words: [{ kind: 'balloon', text: 'Mine' }] },
      ],
    },
  ]);
});
