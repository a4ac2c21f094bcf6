import { expect, test } from 'vitest';
import { damageOf, harshness } from './damage.ts';
import { colourName } from './naming.ts';

/** 12 by 9 cells. */
const signature = (cell: (x: number, y: number) => number[]) =>
  Uint8Array.from(Array.from({ length: 108 }, (_, i) => cell(i % 12, Math.floor(i / 12))).flat());
/** The left half of the photo has the details. */
const energy = {
  columns: 12,
  rows: 9,
  values: Array.from({ length: 108 }, (_, i) => (i % 12 < 6 ? 'f0' : '10')).join(''),
};
const face = { x: 0.25, y: 0.2, width: 0.2, height: 0.3, label: 'face', score: 0.9 };
const tone = [120, 90, 80, 40];
const paper = [255, 250, 245, 2];

test('a picture without its details is burnt, and white paper around a drawing is not', () => {
  expect(
    damageOf(
      { energy, subjects: [] },
      signature(() => tone),
    ),
  ).toBe('');
  expect(
    damageOf(
      { energy, subjects: [] },
      signature((x) => (x < 6 ? paper : tone)),
    ),
  ).toBe('burnt');
  expect(
    damageOf(
      { energy, subjects: [] },
      signature((x) => (x < 6 ? [250, 250, 250, 60] : paper)),
    ),
  ).toBe('');
});

test('a face without features is lost', () => {
  const inFace = (x: number, y: number) => x >= 3 && x < 6 && y >= 1 && y < 5;
  const flat = signature((x, y) => (inFace(x, y) ? [200, 150, 140, 3] : tone));
  expect(damageOf({ energy, subjects: [face] }, flat)).toBe('faceless');
  expect(damageOf({ energy, subjects: [] }, flat)).toBe('');
  expect(
    damageOf(
      { energy, subjects: [face] },
      signature(() => tone),
    ),
  ).toBe('');
  expect(damageOf({ energy, subjects: [{ ...face, label: 'cat' }] }, flat)).toBe('');
});

test('a face that fades against the photo is lost, and noise is found', () => {
  const inFace = (x: number, y: number) => x >= 3 && x < 6 && y >= 1 && y < 5;
  const plain = signature(() => tone);
  const faceOf = (cell: number[], rest = tone) => signature((x, y) => (inFace(x, y) ? cell : rest));
  const damage = (picture: Uint8Array) => damageOf({ energy, subjects: [face] }, picture, plain);
  expect(damage(faceOf([120, 90, 80, 28]))).toBe('');
  expect(damage(faceOf([120, 90, 80, 20]))).toBe('faceless');
  // A face that became lighter must keep more of its features.
  expect(damage(faceOf([230, 220, 210, 28]))).toBe('faceless');
  expect(damage(faceOf([230, 220, 210, 36]))).toBe('');
  expect(damage(faceOf(tone, [120, 90, 80, 100]))).toBe('noisy');
  // A quarter of the midtones is black.
  const black = signature((x) => (x < 3 ? [9, 9, 9, 30] : tone));
  expect(damageOf({ energy, subjects: [] }, black, plain)).toBe('burnt');
  expect(damageOf({ energy, subjects: [] }, black, black)).toBe('');
  // Twice the contrast of the photo, without black and white.
  const steps = (by: number) =>
    signature((x) => (x % 2 ? [128 - by, 128 - by, 128 - by, 40] : [128 + by, 128 + by, 128 + by, 40]));
  expect(damageOf({ energy, subjects: [] }, steps(70), steps(60))).toBe('');
  expect(damageOf({ energy, subjects: [] }, steps(90), steps(40))).toBe('burnt');
  // Without the photo, the checks do not know what is missing.
  expect(damageOf({ energy, subjects: [face] }, faceOf([120, 90, 80, 20]))).toBe('');
});

test('names say the colour, and no two styles share one', () => {
  const taken = new Set<string>();
  const named = (name: string, hue: 'orange' | 'blue', lightness: 'middle' | 'light') => {
    const found = colourName(name, hue, lightness, (other) => taken.has(other));
    taken.add(found);
    return found;
  };
  expect(named('Cold Gouache', 'orange', 'middle')).toBe('Amber Gouache');
  expect(named('Warm Gouache', 'orange', 'middle')).toBe('Amber Gouache 2');
  expect(named('Warm Zine', 'blue', 'light')).toBe('Sky Zine');
});

test('neon colours and bleached areas are harsh, and white paper around lines is not', () => {
  const share = (cell: number[], look = 'flat') =>
    harshness(
      signature((x) => (x < 6 ? cell : tone)),
      look,
    );
  expect(share(tone)).toBe(0);
  expect(share([250, 20, 240, 30])).toBeCloseTo(0.5);
  expect(share([180, 60, 60, 30])).toBeGreaterThan(0.1);
  expect(share(paper)).toBeCloseTo(0.5);
  expect(share(paper, 'line')).toBe(0);
});
