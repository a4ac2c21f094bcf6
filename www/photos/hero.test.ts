import { expect, test } from 'vitest';
import { heroOf, nextHero } from './hero.ts';
import type { PhotoMeta, Subject } from '../engine/types.ts';

const energy = (value: string) => ({ columns: 2, rows: 1, values: value.repeat(2) });
const face = (side: number): Subject => ({ x: 0.3, y: 0.3, width: side, height: side, label: 'face', score: 0.9 });
const photo = (id: string, value: string, subjects: Subject[] = []) =>
  ({ id, energy: energy(value), subjects }) as unknown as PhotoMeta;

/** An album whose page shows the photos in panels that become smaller. */
function album(photos: PhotoMeta[]) {
  const panels = photos.map(({ id }) => ({ photo: id }));
  const boxes = photos.map((_, i) => ({ bounds: { width: 1 / (i + 1), height: 1 } }));
  const store = { photos: { value: photos }, page: { value: { panels } }, geometry: { value: { panels: boxes } } };
  return { store, engine: { hasPhoto: () => true } } as any;
}
const hero = (photos: PhotoMeta[]) => heroOf(album(photos));

test('pictures of styles show the photo with the clearest face', () => {
  expect(
    hero([photo('stream', 'ff'), photo('crowd', '20', Array(9).fill(face(0.12))), photo('one', '40', [face(0.25)])]),
  ).toBe('one');
  // A speck of a face, and one that fills the photo, show little of a style.
  expect(hero([photo('a', '20'), photo('speck', '20', [face(0.02)]), photo('b', '20', [face(0.9)])])).toBe('a');
});

test('a face stays while photos are searched for faces, and the clearest face comes at the end', () => {
  const photos = album([photo('sky', '20'), photo('small', '20', [face(0.15)]), photo('large', '20', [face(0.3)])]);
  expect(nextHero(photos, 'sky', true)).toBe('large');
  expect(nextHero(photos, 'small', true)).toBe('small');
  expect(nextHero(photos, 'small', false)).toBe('large');
  expect(nextHero(album([photo('sky', '20'), photo('bus', '60')]), 'bus', false)).toBe('bus');
});

test('a gray photo comes after photos with colours, and is shown if all are gray', () => {
  const toned = (id: string, chroma: string, subjects: Subject[] = []) => ({
    ...photo(id, '40', subjects),
    facts: '00'.repeat(18) + chroma + '00'.repeat(6),
  });
  expect(hero([toned('gray face', '02', [face(0.25)]), toned('garden', '40')])).toBe('garden');
  expect(hero([toned('gray face', '02', [face(0.25)]), toned('gray', '00')])).toBe('gray face');
});

test('without faces, they show the largest photo of the page that is not among the busiest', () => {
  expect(hero([photo('stream', 'ff'), photo('bus', '60'), photo('sky', '10')])).toBe('bus');
  const cat = { ...face(0.6), label: 'cat' };
  expect(hero([photo('stream', 'ff', [cat]), photo('bus', '60'), photo('cat', '10', [cat])])).toBe('cat');
  expect(hero([photo('only', 'ff')])).toBe('only');
  expect(hero([])).toBe(null);
});
