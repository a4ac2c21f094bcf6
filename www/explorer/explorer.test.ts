import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { ROUND, createExplorer } from './explorer.ts';
import { near } from './explorer-wall.ts';
import { fakeApp } from '../document/testing.ts';

const PHOTO = { id: 'p1', width: 160, height: 120 };

/** What a style looks like, here: its seed in the signature. */
const looks = (style: any) => ({
  score: (style.seed % 100) / 100,
  novelty: 1,
  fault: '',
  look: style.seed % 2 ? 'line' : 'flat',
  signature: Uint8Array.from([style.seed % 256, (style.seed * 50) % 256]),
});

function app(judge: (style: any) => any = looks) {
  const made = fakeApp();
  const bred: any[] = [];
  const planner = {
    ...made.planner,
    inventStyle: (seed: number) => ({ id: `invented-${seed}`, name: `${seed}`, tags: [], seed }),
    breedStyle: (wish: any) => {
      bred.push(wish);
      return { id: `bred-${wish.seed}`, name: 'child', tags: [], seed: 1000 + wish.seed * 10 };
    },
  } as any;
  made.store.planner.value = planner;
  let sent = 0;
  const engine = {
    judges: false,
    exploreStyles: async (_: string, styles: any[], __: any, call: any) => {
      sent += styles.length;
      await new Promise((done) => {
        setTimeout(done, 1);
      });
      if (call.signal.aborted) throw Object.assign(new Error('stopped'), { code: 'cancelled' });
      return styles.map((style, index) => ({ index, ...judge(style), bitmap: { close: () => {} } }));
    },
  };
  const favourites = signal([] as any[]);
  const ownStyles = { favourites, isFavourite: (id: string) => favourites.value.some((style) => style.id === id) };
  let seeds = 0;
  const explorer = createExplorer({ ...made, engine, ownStyles, seed: () => (seeds += 1) } as any);
  return { ...made, explorer, favourites, bred, sent: () => sent };
}

describe('the explorer', () => {
  it('invents a round from its seed, the same again from the same', async () => {
    const { explorer } = app();
    explorer.begin(77);
    await explorer.generate(PHOTO);
    const ids = explorer.items.value.map(({ style }) => style.id);
    expect(ids[0]).toBe('invented-77');
    const again = app().explorer;
    again.begin(77);
    await again.generate(PHOTO);
    expect(again.items.value.map(({ style }) => style.id)).toEqual(ids);
    await again.generate(PHOTO);
    expect(again.items.value.map(({ style }) => style.id)).not.toContain(`invented-${77 + 2 * ROUND}`);
  });

  it('leaves out what is empty, and what looks like another', async () => {
    const { explorer } = app((style) => ({
      ...looks(style),
      fault: style.seed % 3 === 0 ? 'pale' : '',
      signature: Uint8Array.from([style.seed % 3 === 1 ? 9 : style.seed % 256]),
    }));
    explorer.begin(0);
    await explorer.generate(PHOTO);
    const seeds = explorer.items.value.map(({ style }) => (style as any).seed);
    expect(seeds.filter((seed) => seed % 3 === 0)).toEqual([]);
    expect(seeds.filter((seed) => seed % 3 === 1)).toHaveLength(1);
    expect(explorer.dropped.value).toBe(ROUND - seeds.length);
  });

  it('sorts by score and shows one kind of look', async () => {
    const { explorer, favourites } = app();
    explorer.begin(0);
    await explorer.generate(PHOTO);
    explorer.sorted.value = true;
    const scores = explorer.shown.value.map(({ score }) => score);
    expect(scores).toEqual([...scores].sort((a, b) => b - a));
    explorer.look.value = 'line';
    expect(new Set(explorer.shown.value.map(({ look }) => look))).toEqual(new Set(['line']));
    favourites.value = [explorer.items.value[3].style];
    explorer.look.value = 'favourites';
    expect(explorer.shown.value).toHaveLength(1);
  });

  it('breeds two with the dial, and hangs their children first', async () => {
    const { explorer, bred } = app();
    explorer.begin(0);
    await explorer.generate(PHOTO);
    const [a, b] = explorer.items.value.map(({ style }) => style);
    explorer.surprise.value = 0.8;
    await explorer.breed(a, PHOTO);
    expect([explorer.parent.value?.id, bred.length]).toEqual([a.id, 0]);
    await explorer.breed(b, PHOTO);
    expect(explorer.parent.value).toBe(null);
    expect(bred[0]).toMatchObject({ a, b, surprise: 0.8 });
    expect(explorer.items.value[0].style.id).toMatch(/^bred-/);
    const child = explorer.items.value[0].style.id;
    expect(explorer.parentsOf(child)).toEqual([a.name, b.name]);
    expect(explorer.parentsOf(a.id)).toBeUndefined();
    expect(explorer.lastParents.value).toBe(explorer.parentsOf(child));
    await explorer.breed(a, PHOTO);
    await explorer.breed(a, PHOTO);
    expect(explorer.parent.value).toBe(null);
  });

  it('stops at once, and sends no more', async () => {
    const { explorer, sent } = app();
    const round = explorer.generate(PHOTO);
    explorer.stop();
    await round;
    expect(explorer.progress.value).toBe(null);
    expect(sent()).toBeLessThan(ROUND / 4);
  });

  it('hangs favourites of earlier days, whatever they look like', async () => {
    const { explorer, favourites } = app(() => ({
      score: 0,
      novelty: 1,
      fault: 'flat',
      look: 'wild',
      signature: Uint8Array.from([1]),
    }));
    favourites.value = [1, 2].map((seed) => ({ id: `f${seed}`, name: 'F', tags: [], seed }));
    await explorer.showFavourites(PHOTO);
    await explorer.showFavourites(PHOTO);
    expect(explorer.items.value.map(({ style }) => style.id)).toEqual(['f1', 'f2']);
  });
});

it('signatures are near within a few steps', () => {
  const base = new Uint8Array(432).fill(100);
  expect(
    near(
      base,
      base.map((value) => value + 5),
    ),
  ).toBe(true);
  expect(
    near(
      base,
      base.map((value) => value + 9),
    ),
  ).toBe(false);
});
