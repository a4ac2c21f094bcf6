import { expect, it } from 'vitest';
import { core } from '../engine/testing-core.ts';
import { coloured } from './colouring.ts';
import { HUES, coloursOf } from './colours.ts';

/** A signature of cells in these colours. */
const cells = (...colours: [number, number, number][]) =>
  Uint8Array.from(Array.from({ length: 108 }, (_, i) => [...colours[i % colours.length], 20]).flat());

it('tells the hue that a person would name', () => {
  const named: [string, [number, number, number]][] = [
    ['red', [200, 40, 40]],
    ['orange', [220, 130, 50]],
    ['yellow', [235, 210, 60]],
    ['green', [70, 150, 60]],
    ['cyan', [40, 160, 165]],
    ['blue', [50, 90, 200]],
    ['purple', [130, 70, 190]],
    ['pink', [220, 80, 160]],
    ['gray', [128, 126, 129]],
  ];
  expect(named.map(([, colour]) => coloursOf(cells(colour)).hue)).toEqual(named.map(([name]) => name));
  expect(coloursOf(cells([200, 40, 40], [70, 150, 60], [50, 90, 200])).hue).toBe('mixed');
  // Paper with a tint is of that colour.
  expect(coloursOf(cells([255, 240, 200])).hue).toBe('yellow');
});

it('tells dark from light', () => {
  const at = (value: number) => coloursOf(cells([value, value, value])).lightness;
  expect([20, 60, 120, 190, 250].map(at)).toEqual(['dark', 'dark', 'middle', 'light', 'light']);
});

it('of six styles in a row one keeps the colours of the photo, and all are valid files', () => {
  const blocks = core.blocks();
  for (let seed = 0; seed < 400; seed += 1) {
    const plain = core.inventStyle(seed);
    const style = coloured(plain, seed, blocks);
    expect(style === plain).toBe(seed % 6 === 0);
    expect(core.checkStyle(JSON.stringify(style), 'style').background.length).toBe(style.background.length);
    const facts = core.draftFacts(core.draftOf(style));
    expect(facts.background.misfits.filter(Boolean), JSON.stringify(style)).toEqual([]);
    expect(coloured(plain, seed, blocks)).toEqual(style);
  }
});

it('the inks of a round go around the whole wheel, and all are equally dark', () => {
  const blocks = core.blocks();
  const hues = new Set<string>();
  for (let seed = 0; seed < 108; seed += 1) {
    for (const { block, ink_1: ink } of coloured(core.inventStyle(seed), seed, blocks).background) {
      if (block !== 'plates') continue;
      const [red, green, blue] = [1, 3, 5].map((at) => Number.parseInt(String(ink).slice(at, at + 2), 16));
      expect(0.299 * red + 0.587 * green + 0.114 * blue).toBeCloseTo(42, -0.3);
      hues.add(coloursOf(cells([red, green, blue])).hue);
    }
  }
  expect([...hues].sort()).toEqual(HUES.filter((hue) => !['mixed', 'gray'].includes(hue)).sort());
});
