import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { createNarrating } from './narrating.ts';

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
  const narrating = createNarrating({
    store,
    ui,
    album: { title: () => '', moments },
    settled: (page) => page,
    cleared: (page) => page,
  });
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
