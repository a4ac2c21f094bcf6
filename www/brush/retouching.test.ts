/** The brush with its module as the page has it: `cargo xtask module brush` builds it. */

import { readFileSync } from 'node:fs';
import { signal } from '@preact/signals';
import { expect, it, vi } from 'vitest';
import { createHand } from '../engine/brush-module.ts';
import * as module from '../pkg-brush/inkpanel.js';
import { keepSteps } from './keeping-masks.ts';
import { SIZES, createRetouching } from './retouching.ts';

module.initSync({ module: readFileSync(new URL('../pkg-brush/inkpanel_bg.wasm', import.meta.url)) });

const [WIDTH, HEIGHT] = [160, 80];

/** Squares of 10 pixels at these columns, as a detected mask. */
function squares(...columns: number[]) {
  const row = [...columns, 80].map((left, i) => {
    const from = i === 0 ? 0 : columns[i - 1] + 10;
    const gap = left > from ? `a${left - from}` : '';
    return i < columns.length ? `${gap}p10` : gap;
  });
  return `80x40:a1200${row.join('').repeat(10)}a1200`;
}

function begin({ own, found }: { own?: string; found?: string } = {}) {
  const planes = new Uint8Array(3 * WIDTH * HEIGHT).fill(128);
  return createRetouching(createHand(module, [WIDTH, HEIGHT, planes, own, found]));
}

it('a stroke is painted piece by piece and is one step', () => {
  const retouching = begin();
  retouching.press({ x: 0.2, y: 0.5 });
  retouching.strokeTo([
    { x: 0.4, y: 0.5 },
    { x: 0.6, y: 0.5 },
  ]);
  expect(retouching.seen.value.fine).toBe(false);
  expect(retouching.told.value.undoable).toBe(false);
  expect(retouching.lift()).toBe(true);
  const { coverage } = retouching.told.value;
  expect(coverage).toBeGreaterThan(0.03);
  // It has no gaps, however far the points of the pointer are apart.
  const pixels = retouching.draw(false);
  const hides = (x: number) => pixels[4 * (40 * retouching.width + x) + 3];
  expect([40, 48, 80, 90].map(hides)).toEqual([0, 0, 0, 0]);
  expect(hides(140)).toBeGreaterThan(100);
  expect(retouching.steps()).toHaveLength(1);
  retouching.tool.value = 'take';
  retouching.press({ x: 0.4, y: 0.5 });
  expect(retouching.lift()).toBe(true);
  expect(retouching.told.value.coverage).toBeLessThan(coverage);
  retouching.undo();
  expect(retouching.told.value).toMatchObject({ coverage, undoable: true, redoable: true });
  retouching.redo();
  expect(retouching.steps()).toHaveLength(2);
});

it('a stroke that the browser takes away was none', () => {
  const retouching = begin();
  const before = retouching.draw(true);
  retouching.press({ x: 0.5, y: 0.5 });
  expect(retouching.draw(true)).not.toEqual(before);
  retouching.abandon();
  expect(retouching.draw(true)).toEqual(before);
  expect([retouching.lift(), retouching.steps(), retouching.told.value.coverage]).toEqual([false, [], 0]);
});

it('the mask lies over the photo: dark beside the subject, nothing over it', () => {
  const retouching = begin({ found: squares(10, 50) });
  const pixels = retouching.draw(true);
  expect(pixels).toHaveLength(4 * retouching.width * retouching.height);
  const hides = (x: number, y: number) => pixels[4 * (y * retouching.width + x) + 3];
  expect([hides(30, 40), hides(80, 10) > 100]).toEqual([0, true]);
});

it('the keyboard moves the brush, paints where it is and stays on the photo', () => {
  const retouching = begin();
  for (let i = 0; i < 20; i += 1) retouching.move({ x: -1, y: 0 }, true);
  expect(retouching.at.value).toEqual({ x: 0, y: 0.5 });
  retouching.move({ x: 0, y: 1 }, false);
  // A step is as long on the screen in both ways: the photo is twice as wide as high.
  expect(retouching.at.value).toEqual({ x: 0, y: 0.54 });
  expect(retouching.dab()).toBe(true);
  for (let i = 0; i < 40; i += 1) retouching.resize(1);
  expect(retouching.size.value).toBe(SIZES.most);
});

it('a subject is chosen by a press or one after the other, and it is told where there is none', () => {
  const retouching = begin({ found: squares(10, 50) });
  const { coverage } = retouching.told.value;
  retouching.tool.value = 'choose';
  retouching.press({ x: 0.02, y: 0.02 });
  expect([retouching.vain.value, retouching.steps()]).toEqual(['noneHere', []]);
  retouching.press({ x: 55 / 80, y: 0.5 });
  expect([retouching.vain.value, retouching.told.value.coverage]).toEqual([null, coverage / 2]);
  expect(retouching.lift()).toBe(false);
  expect(retouching.mend('NextFigure')).toBe(true);
  expect(retouching.steps()[1]).not.toBe(retouching.steps()[0]);
  const one = begin({ found: squares(10) });
  expect([one.mend('NextFigure'), one.vain.value]).toEqual([false, 'onlyOne']);
});

it('each step is one of the document, and what was found is nobody’s', () => {
  const retouching = begin({ own: squares(50), found: squares(10) });
  expect(retouching.told.value.found).toBe(false);
  retouching.mend('Grow');
  retouching.mend('Found');
  expect(retouching.told.value.found).toBe(true);
  const change = vi.fn();
  const album = signal(new Map([['a', { id: 'a', meta: { mask: 'found' } }]]));
  const store = { change, album, tray: signal([{ id: 'a' }]) } as any;
  keepSteps(store, 'a', retouching.steps());
  const [grown] = retouching.steps();
  expect(change.mock.calls).toEqual([
    [{ type: 'mask-photo', id: 'a', mask: grown, found: 'found' }],
    [{ type: 'mask-photo', id: 'a', mask: null, found: 'found' }],
  ]);
  // A photo that was removed meanwhile is skipped.
  keepSteps(store, 'b', retouching.steps());
  expect(change).toHaveBeenCalledTimes(2);
});
