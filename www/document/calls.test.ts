import { expect, test, vi } from 'vitest';
import { createAlternatives } from '../page/alternatives.ts';
import { createFraming } from '../page/panels/framing.ts';
import { fakeApp } from './testing.ts';
import type { Bounds } from '../engine/types.ts';

/** Calls of the core, with the bytes of their texts in both directions. */
const calls = vi.hoisted(() => [] as { name: string; bytes: number }[]);

vi.mock('../pkg/inkpanel.js', async (original) => {
  const core: any = await original();
  const bytesOf = (values: unknown[]) =>
    values.reduce((sum: number, value) => sum + (typeof value === 'string' ? value.length : 0), 0);
  const counted = (name: string, call: any) =>
    function (this: unknown, ...given: unknown[]) {
      const answer = call.apply(this, given);
      calls.push({ name, bytes: bytesOf([...given, answer]) });
      return answer;
    };
  for (const type of [core.Editor, core.Album])
    for (const name of Object.getOwnPropertyNames(type.prototype))
      if (name !== 'constructor' && name !== 'free' && typeof type.prototype[name] === 'function')
        type.prototype[name] = counted(name, type.prototype[name]);
  const functions = Object.entries(core).map(([name, part]) => [
    name,
    typeof part === 'function' && !part.prototype?.free && !name.startsWith('init') ? counted(name, part) : part,
  ]);
  return { ...core, ...Object.fromEntries(functions) };
});

test('one step of a drag of a photo is one small call of the core', async () => {
  const { store, planner, pages, reading, files, scheduler } = fakeApp();
  // The fake answers these without the core.
  const { geometry, choose } = planner;
  planner.geometry = () => {
    calls.push({ name: 'page_geometry', bytes: 0 });
    return geometry();
  };
  planner.choose = (photos) => {
    calls.push({ name: 'choose_photos', bytes: 0 });
    return choose(photos);
  };
  await reading.addFiles(files('a', 'b', 'c', 'd'));
  const framing = createFraming({ store, pages });
  const { basis } = createAlternatives({ store, pages, scheduler });
  // The app shows these parts while a photo is dragged.
  const seen = [
    store.layoutFacts,
    store.geometry,
    store.photos,
    store.verdicts,
    store.unseen,
    store.layouts,
    store.masks,
    basis,
  ];
  const stop = seen.map((part) => part.subscribe(() => {}));
  framing.closer(0, 2);
  const crop = framing.cropOf(0) as Bounds;
  const gesture = framing.step();
  framing.pan(0, crop, [0.01, 0], gesture);
  calls.length = 0;
  framing.pan(0, crop, [0.02, 0], gesture);
  stop.forEach((end) => end());
  expect(calls.map(({ name }) => name)).toEqual(['apply']);
  expect(calls[0].bytes).toBeLessThan(3000);
});
