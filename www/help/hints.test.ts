import { signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { fakeParts } from '../app/app-testing.ts';
import { createHints } from './hints.ts';

/** The hints over a page that was just made. */
async function begun({ kept = {} as Record<string, string>, refuses = false } = {}) {
  const { store, pages, selection, framing, reshaping, ui } = await fakeParts();
  const lettering = { chosen: signal(-1) };
  const box = () => {
    if (refuses) throw new DOMException('no storage', 'SecurityError');
    return {
      getItem: (key: string) => kept[key] ?? null,
      setItem: (key: string, value: string) => void (kept[key] = value),
    } as unknown as Storage;
  };
  const hints = createHints({ store, selection, lettering, framing, reshaping, ui, box });
  const draw = () => void (ui.painted.value = store.page.peek());
  const shuffle = () => {
    pages.shuffle('all');
    hints.shuffled();
    draw();
  };
  const drag = () => {
    framing.closer(0, 1.5);
    draw();
  };
  return { hints, ui, draw, shuffle, drag, pages, selection, framing, lettering, kept, shown: () => hints.shown.value };
}

it('tells of Shuffle once the page is drawn, until it is shuffled', async () => {
  const { shown, draw, shuffle } = await begun();
  expect(shown()).toBe(null);
  draw();
  expect(shown()).toBe('shuffle');
  shuffle();
  expect(shown()).toBe(null);
});

it.each(['shuffle', 'crop', 'lock'] as const)('ends the hint %s when a text item is selected', async (hint) => {
  const { hints, shown, draw, shuffle, lettering } = await begun();
  draw();
  if (hint !== 'shuffle') shuffle();
  if (hint === 'crop') hints.point(0);
  if (hint === 'lock') shuffle();
  expect(shown()).toBe(hint);
  lettering.chosen.value = 0;
  expect(shown()).toBe(null);
});

it('tells of photos when a panel is pointed at or selected, until one is moved', async () => {
  const { hints, shown, draw, shuffle, drag, selection } = await begun();
  draw();
  hints.point(1);
  expect(shown()).toBe('shuffle');
  hints.point(null);
  shuffle();
  selection.set([0]);
  expect(shown()).toBe('crop');
  drag();
  expect(shown()).toBe(null);
});

it('ends the hint about photos when its panel is not selected any more', async () => {
  const { shown, draw, shuffle, selection } = await begun();
  draw();
  shuffle();
  selection.set([0]);
  expect(shown()).toBe('crop');
  selection.clear();
  expect(shown()).toBe(null);
});

it('ends the hint about photos when the crop ends, when another tool waits for a click, and with two panels', async () => {
  const ends: ((parts: Awaited<ReturnType<typeof begun>>) => void)[] = [
    ({ framing }) => void (framing.cropping.value = null),
    ({ framing }) => void (framing.mode.value = { kind: 'replace', panel: 0 }),
    ({ selection }) => selection.set([0, 1]),
  ];
  for (const end of ends) {
    const parts = await begun();
    parts.draw();
    parts.shuffle();
    parts.selection.set([0]);
    parts.framing.cropping.value = 0;
    expect(parts.shown()).toBe('crop');
    end(parts);
    expect(parts.shown()).toBe(null);
  }
});

it('ends the hint about photos when the next page comes, and the hint about locks after two more', async () => {
  const { shown, draw, shuffle, selection } = await begun();
  draw();
  shuffle();
  selection.set([0]);
  expect(shown()).toBe('crop');
  shuffle();
  expect(shown()).toBe('lock');
  shuffle();
  expect(shown()).toBe('lock');
  shuffle();
  expect(shown()).toBe(null);
});

it('tells of locks after two shuffles, until something is locked', async () => {
  const { shown, draw, shuffle, pages } = await begun();
  draw();
  shuffle();
  shuffle();
  expect(shown()).toBe('lock');
  pages.lock('style', true);
  expect(shown()).toBe(null);
});

it('gives each once ever, and all of them again when one asks for them', async () => {
  const { hints, shown, draw, shuffle, kept } = await begun();
  draw();
  hints.close();
  expect(shown()).toBe(null);
  shuffle();
  shuffle();
  hints.close();
  expect(kept).toEqual({ 'inkpanel.hints': 'shuffle lock' });
  const next = await begun({ kept });
  next.draw();
  next.shuffle();
  next.shuffle();
  expect(next.shown()).toBe(null);
  next.hints.point(0);
  expect(next.shown()).toBe('crop');
  next.hints.begin();
  expect(next.shown()).toBe('shuffle');
});

it('waits while something else has the attention', async () => {
  const { shown, draw, ui } = await begun();
  ui.work.value = 'explorer';
  draw();
  expect(shown()).toBe(null);
  ui.work.value = null;
  expect(shown()).toBe('shuffle');
  ui.dialog.value = 'help';
  expect(shown()).toBe(null);
  ui.dialog.value = null;
  expect(shown()).toBe('shuffle');
});

it('does without storage', async () => {
  const { shown, draw, hints } = await begun({ refuses: true });
  draw();
  expect(shown()).toBe('shuffle');
  hints.close();
  expect(shown()).toBe(null);
});
