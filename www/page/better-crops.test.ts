import { signal } from '@preact/signals';
import { describe, expect, test } from 'vitest';
import { fakeApp } from '../document/testing.ts';
import { createBetterCrops } from './better-crops.ts';
import type { PageDocument } from '../engine/types.ts';

const whole = { x: 0, y: 0, width: 1, height: 1 };
const upper = { x: 0, y: 0, width: 1, height: 0.5 };

/** A page on the screen, and the crops that a new plan would have. */
async function app() {
  const made = fakeApp();
  const painted = signal<PageDocument | null>(null);
  let [time, crop] = [0, whole];
  const { store } = made;
  const preview = () => {
    const page = store.page.peek() as PageDocument;
    const better = { ...page, panels: page.panels.map((panel) => ({ ...panel, crop })) };
    return JSON.stringify(better) === JSON.stringify(page) ? null : better;
  };
  const edit = ({ silent }: { silent?: boolean }) => {
    const page = preview();
    if (page) store.change({ type: 'change-page', page, silent });
    return page !== null;
  };
  await made.reading.addFiles(made.files('a.jpg', 'b.jpg'));
  const crops = createBetterCrops({ store, pages: { preview, edit } as any, ui: { painted }, now: () => time });
  const show = () => {
    painted.value = store.page.value;
  };
  crops.found();
  show();
  return {
    ...made,
    crops,
    show,
    find: (next: typeof whole, after: number) => {
      [time, crop] = [time + after, next];
      crops.found();
    },
    shown: () => store.page.value?.panels.map((panel) => panel.crop),
  };
}

describe('crops that got better', () => {
  test('are taken on the first page while its photos are searched', async () => {
    const { find, shown, crops, store } = await app();
    find(upper, 9_000);
    expect(shown()).toEqual([upper, upper]);
    expect(crops.offered.value).toBeNull();
    expect(store.mirror.value.undos).toBe(0);
  });

  test('are offered on the first page after ten seconds, and accepted as one step', async () => {
    const { find, shown, crops, pages } = await app();
    find(upper, 10_100);
    expect(shown()).toEqual([whole, whole]);
    expect(crops.offered.value).not.toBeNull();
    crops.accept();
    expect(shown()).toEqual([upper, upper]);
    expect(crops.offered.value).toBeNull();
    pages.undo();
    expect(shown()).toEqual([whole, whole]);
  });

  test('that look the same are not offered', async () => {
    const { find, crops } = await app();
    find({ ...whole, width: 0.98 }, 10_100);
    expect(crops.offered.value).toBeNull();
  });

  test('go with the page that they were found for', async () => {
    const { find, crops, pages } = await app();
    find(upper, 10_100);
    pages.shuffle('all');
    expect(crops.offered.value).toBeNull();
  });

  test('of another page are taken within a second, then offered', async () => {
    const { find, crops, pages, show, shown } = await app();
    find(whole, 1100);
    pages.shuffle('all');
    show();
    find(upper, 500);
    expect(crops.offered.value).toBeNull();
    expect(shown()).toEqual([upper, upper]);
    find(whole, 600);
    expect(shown()).toEqual([upper, upper]);
    expect(crops.offered.value).not.toBeNull();
  });
});
