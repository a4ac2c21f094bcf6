import { signal } from '@preact/signals';
import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { FAIR, FIRST, LITTER, ROUND, createExplorer } from './explorer.ts';
import { createWall, near } from './explorer-wall.ts';
import { fakeApp } from '../document/testing.ts';

const PHOTO = { id: 'p1', width: 160, height: 120 };
const OTHER = { id: 'p2', width: 160, height: 120 };

/** The test look of a style: its seed in the signature, with distances above the similarity limit. */
const looks = (style: any) => ({
  score: (style.seed % 100) / 100,
  novelty: 1,
  fault: '',
  look: style.seed % 2 ? 'line' : 'flat',
  clipped: { white: 0, black: 0, lightest: 0, darkest: 0 },
  signature: Uint8Array.from([1, 4, 16, 64].map((place) => (Math.floor(style.seed / place) % 4) * 64)),
});

function app(judge: (style: any, photo: string) => any = looks, model: object = { judges: false }) {
  const made = fakeApp();
  const bred: any[] = [];
  const planner = {
    ...made.planner,
    inventStyle: (seed: number) => ({ id: `invented-${seed}`, name: `${seed}`, tags: [], background: [], seed }),
    breedStyle: (wish: any) => {
      bred.push(wish);
      return { id: `bred-${wish.seed}`, name: 'child', tags: [], background: [], seed: 1000 + wish.seed * 10 };
    },
  } as any;
  made.store.planner.value = planner;
  let sent = 0;
  const engine = {
    ...model,
    exploreStyles: async (photo: string, styles: any[], __: any, call: any) => {
      sent += styles.length;
      await new Promise((done) => {
        setTimeout(done, 1);
      });
      if (call.signal.aborted) throw Object.assign(new Error('stopped'), { code: 'cancelled' });
      return styles.map((style, index) => ({ index, ...judge(style, photo), bitmap: { close: () => {} } }));
    },
  };
  const favourites = signal([] as any[]);
  const ownStyles = { favourites, isFavourite: (id: string) => favourites.value.some((style) => style.id === id) };
  let seeds = 0;
  const explorer = createExplorer({ ...made, engine, ownStyles, seed: () => (seeds += 1) } as any);
  const ids = () => explorer.items.value.map(({ style }) => style.id);
  return { ...made, explorer, ids, favourites, bred, sent: () => sent };
}

/** With some on the wall, from seed 0. */
async function hung(judge?: (style: any, photo: string) => any, model?: object) {
  const made = app(judge, model);
  made.explorer.begin(0);
  await made.explorer.generate(PHOTO);
  return made;
}

describe('the explorer', () => {
  it('opens with a first wall by itself, and with no second one', async () => {
    const { explorer, sent, ids } = app();
    await explorer.open(PHOTO);
    const [before, tried] = [ids(), sent()];
    expect(before.length).toBe(FIRST);
    expect(new Set(explorer.items.value.map(({ harsh }) => harsh)).size).toBeGreaterThan(1);
    await explorer.open(PHOTO);
    expect([sent(), ids()]).toEqual([tried, before]);
  });

  it('shows the first wall in sorted groups, and no style changes its place', async () => {
    const { explorer } = app();
    let before: typeof explorer.items.value = [];
    let groups = 0;
    explorer.items.subscribe((items) => {
      expect(items.slice(0, before.length)).toEqual(before);
      const fresh = items.slice(before.length);
      if (fresh.length > 0) groups += 1;
      // The best first, and harsh ones last.
      const ranks = fresh.map((item) => explorer.scores.points(item) - 100 * item.harsh);
      expect(ranks).toEqual([...ranks].sort((a, b) => b - a));
      before = items;
    });
    await explorer.open(PHOTO);
    expect([before.length, groups]).toEqual([FIRST, FIRST / 24]);
  });

  it('shows the drawn styles of a first wall that is stopped, and none after it is cleared', async () => {
    const { explorer } = app();
    const opening = explorer.open(PHOTO);
    await new Promise<void>((go) => {
      explorer.progress.subscribe((doing) => doing && doing.done > 0 && go());
    });
    expect(explorer.items.value).toEqual([]);
    explorer.stop();
    expect(explorer.items.value.length).toBeGreaterThan(0);
    explorer.clear();
    await opening;
    expect(explorer.items.value).toEqual([]);
  });

  it('leaves out burnt pictures, except the white paper of line drawings', async () => {
    const { explorer } = await hung((style) => ({
      ...looks(style),
      clipped: {
        white: style.seed % 4 < 2 ? 0.5 : 0,
        black: style.seed % 8 === 2 ? 0.5 : 0,
        lightest: 0,
        darkest: 0,
      },
    }));
    const seeds = explorer.items.value.map(({ style }) => (style as any).seed);
    expect(new Set(seeds.map((seed) => seed % 8))).toEqual(new Set([1, 3, 5, 6, 7]));
  });

  it('invents a round from its seed, the same again from the same', async () => {
    const { explorer, ids } = app();
    explorer.begin(78);
    await explorer.generate(PHOTO);
    // The first of six has the colours of the photo, and is the style that a shuffle would draw.
    expect(ids().slice(0, 4)).toEqual(['invented-78', 'coloured-79', 'coloured-80', 'coloured-81']);
    const again = app();
    again.explorer.begin(78);
    await again.explorer.generate(PHOTO);
    expect(again.ids()).toEqual(ids());
    await again.explorer.generate(PHOTO);
    expect(again.ids()).not.toContain(`invented-${78 + 2 * ROUND}`);
  });

  it('goes on until a fair number of styles is added, and stops if there are none', async () => {
    const few = (style: any) => ({ ...looks(style), fault: style.seed % 6 === 0 ? '' : 'pale' });
    const { explorer, ids } = await hung(few);
    expect(ids().length).toBeGreaterThanOrEqual(FAIR);
    expect(ids().length + explorer.dropped.value).toBe(2 * ROUND);
    const again = await hung(few);
    expect(again.ids()).toEqual(ids());
    await explorer.generate(PHOTO);
    expect(ids().slice(0, again.ids().length)).toEqual(again.ids());
    const none = await hung((style) => ({ ...looks(style), fault: 'pale' }));
    expect([none.ids(), none.explorer.progress.value]).toEqual([[], null]);
  });

  it('shows one progress over all rounds', async () => {
    const made = app((style: any) => ({ ...looks(style), fault: style.seed % 6 === 0 ? '' : 'pale' }));
    const steps: number[] = [];
    made.explorer.progress.subscribe((doing) => steps.push(doing ? doing.done : -1));
    await made.explorer.generate(PHOTO);
    // It is hidden before and after, and never starts again.
    expect(steps.filter((done) => done <= 0)).toEqual([-1, 0, -1]);
    expect(Math.max(...steps)).toBe(2 * ROUND);
    expect(steps.slice(1, -1)).toEqual([...steps.slice(1, -1)].sort((a, b) => a - b));
  });

  it('leaves out what is empty, and what looks like another', async () => {
    const { explorer } = await hung((style) => ({
      ...looks(style),
      fault: style.seed % 3 === 0 ? 'pale' : '',
      signature: Uint8Array.from([style.seed % 3 === 1 ? 9 : style.seed % 256, 0, 0, 0]),
    }));
    const seeds = explorer.items.value.map(({ style }) => (style as any).seed);
    expect(seeds.filter((seed) => seed % 3 === 0)).toEqual([]);
    expect(seeds.filter((seed) => seed % 3 === 1)).toHaveLength(1);
    expect(explorer.dropped.value).toBe(ROUND - seeds.length);
  });

  it('has every style stay in its place until it is sorted, and sorts once', async () => {
    const { explorer, ids } = await hung();
    const before = ids();
    await explorer.generate(PHOTO);
    expect(ids().slice(0, before.length)).toEqual(before);
    explorer.sort();
    const points = () => explorer.shown.value.map(explorer.scores.points);
    expect(points()).toEqual(points().sort((a, b) => b - a));
    expect(explorer.unsorted.value).toBe(false);
    const sorted = ids();
    await explorer.generate(PHOTO);
    expect(ids().slice(0, sorted.length)).toEqual(sorted);
    expect(explorer.unsorted.value).toBe(ids().length > sorted.length);
  });

  it('sorts again once the model has scored all styles, but not after a later round', async () => {
    const model = { judges: true, hasPhoto: () => true, judgeStyle: async (_: string, style: any) => style.seed % 7 };
    const { explorer, ids } = await hung(undefined, model);
    explorer.sort();
    await vi.waitFor(() => expect(explorer.scores.progress.value).toBe(null));
    const points = () => explorer.shown.value.map(explorer.scores.points);
    expect(points()).toEqual(points().sort((a, b) => b - a));
    expect(new Set(points()).size).toBeGreaterThan(3);
    const sorted = ids();
    await explorer.generate(PHOTO);
    await vi.waitFor(() => expect(explorer.scores.progress.value).toBe(null));
    expect(ids().slice(0, sorted.length)).toEqual(sorted);
  });

  it('shows one kind of look, one hue, one lightness', async () => {
    const { explorer } = await hung();
    const all = explorer.shown.value.length;
    explorer.filter('line');
    expect(new Set(explorer.shown.value.map(({ look }) => look))).toEqual(new Set(['line']));
    explorer.filter('all');
    const kinds = new Map<string, number>();
    for (const { hue } of explorer.items.value) kinds.set(hue, (kinds.get(hue) ?? 0) + 1);
    expect(kinds.size).toBeGreaterThan(3);
    for (const [hue, count] of kinds) {
      explorer.hue.value = hue as any;
      expect(explorer.shown.value).toHaveLength(count);
    }
    explorer.lightness.value = 'dark';
    expect(explorer.shown.value.length).toBeLessThan(all);
  });

  it('keeps a favourite that is let go in its place until favourites are asked for again', async () => {
    const { explorer, favourites } = await hung();
    favourites.value = explorer.items.value.slice(2, 5).map(({ style }) => style);
    explorer.filter('favourites');
    expect(explorer.shown.value).toHaveLength(3);
    favourites.value = favourites.value.slice(1);
    expect(explorer.shown.value).toHaveLength(3);
    explorer.filter('favourites');
    expect(explorer.shown.value).toHaveLength(2);
  });

  it('breeds two with the dial, and hangs their children beside the second', async () => {
    const { explorer, bred, ids } = await hung();
    const before = ids();
    const [a, b] = [explorer.items.value[1].style, explorer.items.value[5].style];
    explorer.surprise.value = 0.8;
    await explorer.breed(a, PHOTO);
    expect([explorer.parent.value?.id, bred.length]).toEqual([a.id, 0]);
    await explorer.breed(b, PHOTO);
    expect(explorer.parent.value).toBe(null);
    expect(bred[0]).toMatchObject({ a, b, surprise: 0.8 });
    const children = ids().filter((id) => id.startsWith('bred-'));
    expect(children.length).toBeGreaterThan(0);
    expect(ids()).toEqual([...before.slice(0, 6), ...children, ...before.slice(6)]);
    expect(explorer.parentsOf(children[0])?.map(({ name }) => name)).toEqual([a.name, b.name]);
    expect(explorer.parentsOf(a.id)).toBeUndefined();
    expect(explorer.lastParents.value).toBe(explorer.parentsOf(children[0]));
    await explorer.breed(a, PHOTO);
    await explorer.breed(a, PHOTO);
    expect(explorer.parent.value).toBe(null);
  });

  it('tries more children where some look alike, and hangs no more than a litter', async () => {
    const alike = (style: any) => ({
      ...looks(style),
      ...(style.name === 'child' && { signature: new Uint8Array(4).fill(((style.seed / 10) % 24) * 10) }),
    });
    const { explorer, bred, ids } = await hung(alike);
    await explorer.moreLike(explorer.items.value[0].style, PHOTO);
    const children = ids().filter((id) => id.startsWith('bred-'));
    expect(children.length).toBeLessThanOrEqual(LITTER);
    expect(bred.length).toBeGreaterThan(LITTER);
  });

  it('shows children whatever the wall is filtered by, until it is filtered anew', async () => {
    const { explorer, favourites } = await hung();
    favourites.value = [explorer.items.value[0].style];
    explorer.filter('favourites');
    await explorer.moreLike(explorer.items.value[0].style, PHOTO);
    expect(explorer.shown.value.length).toBeGreaterThan(1);
    explorer.filter('favourites');
    expect(explorer.shown.value).toHaveLength(1);
  });

  it('puts the wall on another photo, each style in its place, and drops what is alike there', async () => {
    const { explorer, ids } = await hung((style, photo) => ({
      ...looks(style),
      fault: photo === 'p2' && style.seed % 5 === 0 ? 'pale' : '',
    }));
    const before = explorer.items.value.map(({ style }) => style as any);
    await explorer.open(OTHER);
    expect(explorer.items.value.every(({ photo }) => photo.id === 'p2')).toBe(true);
    expect(ids()).toEqual(before.filter(({ seed }) => seed % 5 !== 0).map(({ id }) => id));
  });

  it('redraws the rest before it invents, where putting it on another photo was stopped', async () => {
    const { explorer } = await hung();
    const moving = explorer.open(OTHER);
    expect(explorer.progress.value?.what).toBe('redraw');
    await vi.waitFor(() => expect(explorer.progress.value?.done).toBeGreaterThan(0), { interval: 1 });
    explorer.stop();
    await moving;
    expect(new Set(explorer.items.value.map(({ photo }) => photo.id))).toEqual(new Set(['p1', 'p2']));
    await explorer.generate(OTHER);
    expect(new Set(explorer.items.value.map(({ photo }) => photo.id))).toEqual(new Set(['p2']));
  });

  it('stops at once, and sends no more', async () => {
    const { explorer, sent } = app();
    const round = explorer.generate(PHOTO);
    await vi.waitFor(() => expect(sent()).toBeGreaterThan(0), { interval: 1 });
    explorer.stop();
    await round;
    expect(explorer.progress.value).toBe(null);
    expect(sent()).toBeLessThan(ROUND / 4);
  });

  it('hangs favourites of earlier days first, whatever they look like', async () => {
    const { explorer, favourites, ids } = app((style) => ({
      ...looks(style),
      fault: 'flat',
      signature: Uint8Array.from([1, 1, 1, 1]),
    }));
    favourites.value = [1, 2].map((seed) => ({ id: `f${seed}`, name: 'F', tags: [], background: [], seed }));
    await explorer.open(PHOTO);
    await explorer.open(PHOTO);
    expect(ids()).toEqual(['f1', 'f2']);
  });
});

describe('the wall', () => {
  it('never has two that look the same, whatever comes, on whatever photo', () => {
    const picture = fc.record({ at: fc.nat(40), cells: fc.array(fc.nat(3), { minLength: 4, maxLength: 4 }) });
    const step = fc.record({
      photo: fc.constantFrom('p1', 'p2'),
      redraw: fc.boolean(),
      pictures: fc.uniqueArray(picture, { maxLength: 12, selector: ({ at }) => at }),
    });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 8 }), (steps) => {
        const wall = createWall(() => false);
        const drawn = new Map<string, { photo: string; signature: Uint8Array }>();
        for (const { photo, redraw, pictures } of steps) {
          const styles = pictures.map(({ at }) => ({ id: `s${at}`, name: '', tags: [], background: [] }));
          const explored = pictures.map(({ cells }, index) => ({
            index,
            score: 0.5,
            novelty: 1,
            fault: '',
            look: 'wild',
            signature: Uint8Array.from(cells.map((cell) => cell * 6)),
            clipped: { white: 0, black: 0, lightest: 0, darkest: 0 },
            bitmap: { close: () => {} } as ImageBitmap,
          }));
          const on = { ...PHOTO, id: photo };
          const fresh = redraw ? [] : wall.sift(on, styles, explored, { choosy: true });
          const hung = new Set(fresh.map(({ style }) => style.id));
          wall.hang(fresh);
          if (redraw) wall.redraw(on, styles, explored);
          styles.forEach(({ id }, i) => {
            const kept = wall.items.value.some((item) => item.style.id === id && item.photo.id === photo);
            if (kept && (redraw || hung.delete(id))) drawn.set(id, { photo, signature: explored[i].signature });
          });
        }
        const all = wall.items.value.map(({ style }) => drawn.get(style.id));
        for (const [i, a] of all.entries()) {
          for (const b of all.slice(i + 1))
            if (a && b && a.photo === b.photo) expect(near(a.signature, b.signature)).toBe(false);
        }
      }),
    );
  });
});

it('signatures are near within a few steps, and within more steps if they have one main colour', () => {
  const filled = (...cell: number[]) => Uint8Array.from({ length: 432 }, (_, i) => cell[i % 4]);
  const red = filled(150, 90, 90, 20);
  const [darker, rougher, dark] = [filled(140, 80, 80, 20), filled(150, 90, 90, 49), filled(135, 75, 75, 20)];
  const [purple, orange] = [filled(142, 82, 102, 20), filled(150, 112, 90, 28)];
  expect([darker, rougher, dark].map((one) => near(red, one))).toEqual([true, true, false]);
  // The first has another main colour at a distance of 7, the second at a distance of 7.5.
  expect([purple, orange].map((one) => near(red, one))).toEqual([true, false]);
});
