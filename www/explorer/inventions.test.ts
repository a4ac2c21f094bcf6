import { expect, it, vi } from 'vitest';
import { createInventions } from './inventions.ts';
import { fakeApp } from '../document/testing.ts';
import { eagerScheduler } from '../engine/testing.ts';

type Judge = (
  seed: number,
  photo: string,
) => { fault: string; score: number; clipped?: { white: number; black: number } };

async function app(judge: Judge, { judges = false, judged = true, mean = (_: number): number => 9 } = {}) {
  const made = fakeApp();
  const asked: { photo: string; width: number; height: number }[] = [];
  made.store.planner.value = {
    ...made.planner,
    blocks: () => [],
    inventStyle: (seed: number) => ({ id: `invented-${seed}`, name: '', tags: [], background: [], seed }),
  } as any;
  const seedOf = ({ id }: any) => Number(id.split('-')[1]);
  const engine = {
    judges,
    hasPhoto: () => true,
    exploreStyles: async (photo: string, styles: any[], { width, height }: any) => {
      asked.push({ photo, width, height });
      const clipped = { white: 0, black: 0 };
      const bitmap = { close: () => {} };
      return styles.map((style, index) => ({ index, clipped, bitmap, ...judge(seedOf(style), photo) }));
    },
    judgeStyle: async (_: string, style: any) => mean(seedOf(style)),
  };
  let seeds = 0;
  const seed = () => (seeds += 4) - 4;
  const inventions = createInventions({
    ...made,
    engine,
    seed,
    idle: () => true,
    judged,
    scheduler: eagerScheduler(),
  } as any);
  await made.reading.addFiles(made.files('a', 'b', 'c', 'd'));
  const ids = () => inventions.ready.value.map(seedOf);
  return { ...made, asked, ids };
}

it('keeps styles ready that show something on each of three photos, at 448 pixels', async () => {
  const { ids, asked } = await app((seed) => ({ fault: seed % 2 ? 'pale' : '', score: seed % 4 ? 0.2 : 0.8 }));
  await vi.waitFor(() => expect(ids().length).toBeGreaterThanOrEqual(6));
  expect(ids().every((seed) => seed % 4 === 0)).toBe(true);
  expect(new Set(asked.map(({ photo }) => photo)).size).toBe(3);
  expect(asked.every(({ width, height }) => Math.max(width, height) === 448)).toBe(true);
});

it('leaves out what the net gives little, and what one of the photos is lost in', async () => {
  const fine: Judge = () => ({ fault: '', score: 0.9 });
  const { ids } = await app(fine, { judges: true, mean: (seed) => (seed % 4 === 1 ? 6 : 3) });
  await vi.waitFor(() => expect(ids().length).toBeGreaterThanOrEqual(6));
  expect(ids().every((seed) => seed % 4 === 1)).toBe(true);
  const photos = new Set<string>();
  const none = await app((_, photo) => ({ fault: photos.add(photo).size > 1 ? 'murky' : '', score: 0.9 }));
  await vi.waitFor(() => expect(none.asked.length).toBeGreaterThan(10));
  expect(none.ids()).toEqual([]);
});

it('leaves out burnt pictures, compared with the photo', async () => {
  const { ids } = await app((seed) => {
    // The photo without a style has a white sky.
    const white = Number.isNaN(seed) ? 0.3 : seed % 2 ? 0.4 : 0.5;
    return { fault: '', score: 0.9, clipped: { white, black: 0, lightest: 0, darkest: 0 } };
  });
  await vi.waitFor(() => expect(ids().length).toBeGreaterThanOrEqual(6));
  expect(ids().every((seed) => seed % 2 === 1)).toBe(true);
});

it('does without the net where none is wanted', async () => {
  const mean = vi.fn(() => 1);
  const { ids } = await app(() => ({ fault: '', score: 0.9 }), { judges: true, judged: false, mean });
  await vi.waitFor(() => expect(ids().length).toBeGreaterThanOrEqual(6));
  expect(mean).not.toHaveBeenCalled();
});

it('forgets the styles when another project is opened', async () => {
  const { ids, store } = await app(() => ({ fault: '', score: 0.9 }));
  await vi.waitFor(() => expect(ids().length).toBeGreaterThanOrEqual(6));
  const place = { ...store.place.value, id: 'another' };
  store.load({ editing: null, album: new Map(), videos: new Map(), place });
  expect(ids()).toEqual([]);
});
