import { expect, test } from 'vitest';
import { damageOf, harshness, isClipped } from './damage.ts';
import { clippedParts } from '../engine/style-operations.ts';
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

test('a picture of a dark photo without its middle tones is clipped, in any colours', () => {
  /** Pixels of a ramp, in the colours of a tone from 0 to 1. */
  const drawn = (colour: (tone: number) => number[]) =>
    clippedParts(Array.from({ length: 1000 }, (_, i) => [...colour(i / 1000), 255]).flat());
  // Most tones of the photo are dark.
  const photo = drawn((tone) => Array(3).fill(200 * tone ** 2));
  expect([photo.darkest, photo.lightest].map((part) => Math.round(10 * part))).toEqual([2, 0]);
  const clipped = (look: string, colour: (tone: number) => number[]) =>
    isClipped({ clipped: drawn(colour), look }, photo);
  expect(clipped('flat', (tone) => [80 + 150 * tone ** 2, 40 + 100 * tone, 20])).toBe(false);
  // Dark green shadows below three quarters of the tones, and yellow above.
  const harsh = (tone: number) => (tone < 0.75 ? [0, 40, 20] : [200, 120 + 100 * tone, 90]);
  expect(clipped('flat', harsh)).toBe(true);
  // Two tones are a drawing of lines if few pixels are dark.
  const twoTones = (dark: number) => (tone: number) => (tone < dark ? [20, 20, 60] : [250, 240, 220]);
  expect(clipped('wild', twoTones(0.2))).toBe(true);
  expect(clipped('line', twoTones(0.2))).toBe(false);
  expect(clipped('line', twoTones(0.6))).toBe(true);
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
