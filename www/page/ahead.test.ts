import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { fakeApp } from '../document/testing.ts';
import { createAhead } from './ahead.ts';
import type { PageDocument } from '../engine/types.ts';

vi.useFakeTimers();

async function opened(hooks?: Parameters<typeof fakeApp>[1]) {
  const app = fakeApp({}, hooks);
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg'));
  const painted = signal(app.store.page.value);
  const ahead = createAhead({ ...app, ui: { painted } });
  return { ...app, painted, ahead };
}

test('the next page is planned while this one is looked at, and is the one that Shuffle shows', async () => {
  const { ahead, pages, planner, store } = await opened();
  expect(ahead.page.value).toBeNull();
  await vi.runAllTimersAsync();
  const next = ahead.page.value;
  expect(next).not.toBeNull();
  const { length } = planner.wishes;
  pages.shuffle('all');
  expect(store.page.value).toBe(next);
  expect(planner.wishes).toHaveLength(length);
  expect(ahead.page.value).toBeNull();
});

test('a page in a slow style is drawn during a long rest, and shown when it is drawn', async () => {
  const { ahead, pages, planner, store, painted } = await opened({
    asked: (wish) => ({ ...wish, styling: { invented: 0 } }),
  });
  planner.planned = (page, { draw }) => (draw.styling.quick ? page : { ...page, style: 'painter-night' });
  for (const drawn of [false, true]) {
    await vi.advanceTimersByTimeAsync(500);
    const quick = ahead.page.value;
    expect(quick?.style).not.toBe('painter-night');
    await vi.runAllTimersAsync();
    const slow = ahead.page.value;
    expect(slow?.style).toBe('painter-night');
    if (drawn) pages.drawn(slow as PageDocument);
    pages.shuffle('all');
    expect(store.page.value).toBe(drawn ? slow : quick);
    painted.value = store.page.value;
  }
});

test('whatever changes makes it another', async () => {
  const { ahead, pages, store, painted } = await opened();
  await vi.runAllTimersAsync();
  const next = ahead.page.value;
  pages.lock('style', true);
  expect(ahead.page.value).toBeNull();
  const { style } = store.page.value ?? {};
  pages.shuffle('all');
  expect(store.page.value).not.toBe(next);
  expect(store.page.value?.style).toBe(style);
  // Not before the page is visible.
  await vi.runAllTimersAsync();
  expect(ahead.page.value).toBeNull();
  painted.value = store.page.value;
  await vi.runAllTimersAsync();
  expect(ahead.page.value?.style).toBe(style);
});

test('it is planned at once after a shuffle, and after a rest while the same page changes', async () => {
  const { ahead, pages, store, painted, scheduler } = await opened();
  await vi.runAllTimersAsync();
  const show = async (change: () => void) => {
    scheduler.hold(true);
    change();
    painted.value = store.page.value;
    scheduler.hold(false);
    await vi.advanceTimersByTimeAsync(10);
  };
  await show(() => pages.shuffle('all'));
  expect(ahead.page.value).not.toBeNull();
  const page = store.page.value as PageDocument;
  await show(() => store.change({ type: 'change-page', page: { ...page, seed: page.seed + 1 } }));
  expect(ahead.page.value).toBeNull();
  await vi.advanceTimersByTimeAsync(400);
  expect(ahead.page.value).not.toBeNull();
});

test('it is planned while the page before is drawn, and drawn after', async () => {
  const { ahead, pages, store, painted, planner } = await opened();
  await vi.runAllTimersAsync();
  pages.shuffle('all');
  const { length } = planner.wishes;
  await vi.advanceTimersByTimeAsync(0);
  expect(planner.wishes).toHaveLength(length + 1);
  expect(ahead.page.value).toBeNull();
  painted.value = store.page.value;
  await vi.advanceTimersByTimeAsync(500);
  expect(planner.wishes).toHaveLength(length + 1);
  expect(ahead.page.value).not.toBeNull();
});

test('a page that is painted at once is shown before the next one is planned', async () => {
  const { pages, store, painted, planner, scheduler } = await opened();
  await vi.runAllTimersAsync();
  scheduler.hold(true);
  pages.shuffle('all');
  const { length } = planner.wishes;
  painted.value = store.page.value;
  await vi.advanceTimersByTimeAsync(0);
  expect(planner.wishes).toHaveLength(length);
});
