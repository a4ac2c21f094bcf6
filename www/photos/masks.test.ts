import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import { createMasks } from './masks.ts';
import { fakeApp } from '../document/testing.ts';
import { failure } from '../engine/protocol.ts';

/** @param find returns the mask of a photo */
function app(find: (id: string, signal?: AbortSignal) => Promise<string>, has = true) {
  const made = fakeApp();
  const asked: string[] = [];
  const known: Map<string, string | undefined> = new Map();
  const rested = signal(false);
  const engine = {
    masks: has,
    hasPhoto: () => true,
    knowMask: (id: string, mask: string | undefined) => void known.set(id, mask),
    findMask: (id: string, call?: { signal?: AbortSignal }) => {
      asked.push(id);
      return find(id, call?.signal);
    },
  };
  const found = vi.fn();
  const masks = createMasks({ ...made, engine, ready: () => rested.value, onFound: found });
  return { ...made, asked, known, rested, found, masks };
}

const settle = () =>
  new Promise((done) => {
    setTimeout(done, 10);
  });

describe('masks', () => {
  it('are made when all else is at rest, and kept with the photo', async () => {
    const { reading, files, masks, asked, known, rested, store } = app(async () => '2x2:ap3');
    await reading.addFiles(files('1.jpg', '2.jpg'));
    await settle();
    expect(asked).toEqual([]);
    expect(masks.settled.value).toBe(false);
    rested.value = true;
    await settle();
    expect(asked).toEqual(['p1', 'p2']);
    expect(store.album.value.get('p2')?.meta?.mask).toBe('2x2:ap3');
    // New drawings use it.
    expect(known.get('p2')).toBe('2x2:ap3');
    expect(masks.settled.value).toBe(true);
    expect(masks.progress.value).toBeNull();
  });

  it('say when the photos of the page were looked at, once, so that it may be cropped anew', async () => {
    const { reading, files, found, rested, store } = app(async () => '2x2:ap3');
    await reading.addFiles(files('1.jpg', '2.jpg', '3.jpg'));
    const shown = store.page.value?.panels.flatMap(({ photo }) => photo ?? []) ?? [];
    expect(shown.length).toBeGreaterThan(0);
    rested.value = true;
    await settle();
    expect(found).toHaveBeenCalledTimes(1);
  });

  it('stop where somebody waits for something else, and go on', async () => {
    const found = app(async () => {
      found.rested.value = false;
      return '1x1:a';
    });
    await found.reading.addFiles(found.files('1.jpg', '2.jpg'));
    found.rested.value = true;
    await settle();
    expect(found.asked).toEqual(['p1']);
    found.rested.value = true;
    await settle();
    expect(found.asked).toEqual(['p1', 'p2']);
  });

  it('are looked for no more once a person stops that, until somebody asks for it', async () => {
    const never = (_: string, left?: AbortSignal) =>
      new Promise<string>((_done, failed) => {
        left?.addEventListener('abort', () => failed(failure('cancelled', 'stopped')));
      });
    let find: typeof never = never;
    const { reading, files, masks, asked, rested, store } = app((id, left) => find(id, left));
    await reading.addFiles(files('1.jpg', '2.jpg'));
    rested.value = true;
    await settle();
    expect([asked, masks.progress.value, masks.held.value]).toEqual([['p1'], { done: 0, total: 2 }, false]);
    masks.stop();
    await settle();
    expect([masks.progress.value, masks.held.value, masks.settled.value]).toEqual([null, true, true]);
    // It does not restart automatically: neither with more photos, nor when the app is idle again.
    await reading.addFiles(files('3.jpg'));
    rested.value = false;
    rested.value = true;
    await settle();
    expect(asked).toEqual(['p1']);
    find = async () => '2x2:ap3';
    masks.goOn();
    await settle();
    expect(asked).toEqual(['p1', 'p1', 'p2', 'p3']);
    expect([masks.held.value, store.masks.value.size]).toEqual([false, 3]);
  });

  it('that a person corrected are what is drawn by, and are not looked for', async () => {
    const { reading, files, asked, known, rested, store } = app(async () => '2x2:ap3');
    await reading.addFiles(files('1.jpg', '2.jpg'));
    store.change({ type: 'mask-photo', id: 'p1', mask: '2x2:p4' });
    rested.value = true;
    await settle();
    expect([asked, known.get('p1'), known.get('p2')]).toEqual([['p2'], '2x2:p4', '2x2:ap3']);
    expect(store.photos.value.map(({ mask }) => mask)).toEqual(['2x2:p4', '2x2:ap3']);
    store.change({ type: 'mask-photo', id: 'p2', mask: '2x2:a4', found: '2x2:ap3' });
    expect([known.get('p2'), store.album.value.get('p2')?.meta?.mask]).toEqual(['2x2:a4', '2x2:ap3']);
    // The detected mask counts again, and missing masks are detected.
    store.change({ type: 'undo' });
    store.change({ type: 'mask-photo', id: 'p1', mask: null });
    expect(known.get('p2')).toBe('2x2:ap3');
    await settle();
    expect([asked, known.get('p1')]).toEqual([['p2', 'p1'], '2x2:ap3']);
  });

  it('go on after a photo that cannot be looked at, not without the net', async () => {
    const one = app((id) => (id === 'p1' ? Promise.reject(failure('detector', 'broken')) : Promise.resolve('1x1:a')));
    await one.reading.addFiles(one.files('1.jpg', '2.jpg'));
    one.rested.value = true;
    await settle();
    expect(one.asked).toEqual(['p1', 'p2']);
    expect([one.masks.settled.value, one.masks.there.value]).toEqual([true, true]);
    const none = app(() => Promise.reject(failure('detector-missing', 'not here')));
    await none.reading.addFiles(none.files('1.jpg', '2.jpg'));
    none.rested.value = true;
    await settle();
    expect(none.asked).toEqual(['p1']);
    expect([none.masks.settled.value, none.masks.there.value]).toEqual([true, false]);
    expect(app(async () => '', false).masks.there.value).toBe(false);
  });
});
