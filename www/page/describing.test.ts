import { expect, it } from 'vitest';
import { describePage, describePanel, seenIn } from './describing.ts';

const box = (label: string, x = 0.4, score = 0.9) => ({ label, score, x, y: 0.4, width: 0.1, height: 0.1 });

const page = (panels: any[], more: object = {}): any => ({ panels, merges: [], ...more });

const album = (photos: Record<string, any[]>): any =>
  new Map(Object.entries(photos).map(([id, subjects]) => [id, { id, name: id, meta: { subjects } }]));

it('counts a person once, be it by the face or as a whole', () => {
  expect(seenIn([box('face'), box('person'), box('person', 0.6)], null)).toEqual([{ label: 'person', count: 2 }]);
  expect(seenIn([box('face'), box('dog')], null)).toEqual([
    { label: 'person', count: 1 },
    { label: 'dog', count: 1 },
  ]);
});

it('names what the crop shows and the net is sure of', () => {
  const crop = { x: 0, y: 0, width: 0.5, height: 1 };
  expect(seenIn([box('cat'), box('dog', 0.8), box('kite', 0.2, 0.4)], crop)).toEqual([{ label: 'cat', count: 1 }]);
});

it('describes merged panels by the photo that they share', () => {
  const panels = [
    { photo: 'a', crop: null },
    { photo: 'b', crop: null },
  ];
  const photos = album({ a: [box('cat')], b: [box('dog')] });
  expect(describePanel(page(panels), photos, 1)).toBe('a dog');
  expect(describePanel(page(panels, { merges: [[0, 1]] }), photos, 1)).toBe('a cat');
});

it('writes a page as one text, words and empty panels too', () => {
  const panels = [
    { photo: 'a', crop: null },
    { photo: 'b', crop: null },
    { photo: null, crop: null },
  ];
  const words = [{ kind: 'balloon', text: 'Look\n out!' }];
  expect(describePage(page(panels, { words }), album({ a: [box('person'), box('apple')], b: [] }), 'Noir')).toBe(
    'A comic page of 3 panels in the style Noir. Panel 1: a person and an apple. Panel 2: a photo. Panel 3: empty. Balloon: “Look out!”.',
  );
});
