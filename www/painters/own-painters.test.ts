/** Models of painters of the user in a real database, checked by the core. */

import 'fake-indexeddb/auto';
import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { core } from '../engine/testing-core.ts';
import { smallModel } from '../engine/testing-painters.ts';
import { createMessages } from '../ui/messages.ts';
import { createModelShelf } from './model-shelf.ts';
import { createOwnPainters } from './own-painters.ts';
import { modelsOf, partsOf, referenceOf, referencesIn } from './references.ts';
import type { DraftEdit, Style } from '../engine/types.ts';

let databases = 0;

const styleOf = (model: string): Style => ({
  id: 'own',
  name: 'Own',
  tags: [],
  background: [{ block: 'painter', painter: 2, model }],
});

/** @param name of the database, to open the app again */
function app(name = `models-${(databases += 1)}`, shelf = createModelShelf(name)) {
  const messages = createMessages();
  const page = signal(null as { style: Style } | null);
  const draft = signal(null as any);
  const work = signal(null as any);
  const change = vi.fn((_: DraftEdit) => {});
  const store = { planner: signal(core), page } as any;
  const painters = createOwnPainters({ store, messages, designer: { draft, change }, ui: { work }, shelf });
  const told = () => messages.list.value.map(({ text }) => text);
  return { ...painters, name, messages, page, draft, work, change, told };
}

const file = (bytes: Uint8Array<ArrayBuffer>, name = 'Starry night.onnx') => new File([bytes], name);

test('a model is checked, named, and there after a reload', async () => {
  const first = app();
  const reference = await first.add(file(smallModel({ painters: 12 })));
  expect(reference).toMatch(/^[0-9a-f]{16} Starry night\.onnx$/);
  const { id } = partsOf(reference);
  expect(first.models.value.get(id)).toMatchObject({ name: 'Starry night.onnx', painters: 12 });
  // The core accepts the reference, with a painter number above the last built-in painter.
  const style = { ...styleOf(reference), background: [{ block: 'painter', painter: 12, model: reference }] };
  expect(core.checkStyle(JSON.stringify(style), 'own')).toEqual(style);
  const again = app(first.name);
  const kept = (await again.files([id, 'ffffffffffffffff']))[id];
  expect(new Uint8Array(await kept.arrayBuffer())).toEqual(smallModel({ painters: 12 }));
  expect(again.models.value.get(id)).toMatchObject({ name: 'Starry night.onnx', painters: 12 });
  // Equal content has an equal reference.
  expect(await again.add(file(smallModel({ painters: 12 }), 'other.onnx'))).toBe(`${id} other.onnx`);
  expect(again.models.value.size).toBe(1);
});

test('files that are no models are refused with a code, and nothing is lost', async () => {
  const { add, open, models, messages } = app();
  const { id } = partsOf(await add(file(smallModel())));
  const noise = Uint8Array.from({ length: 3_000 }, (_, i) => (i * 7919) % 251);
  const large = { name: 'large.onnx', size: 5_000_000, arrayBuffer: vi.fn() };
  for (const [given, code] of [
    [file(noise), 'damaged-painters'],
    [file(smallModel().slice(0, 300)), 'damaged-painters'],
    [file(smallModel({ last: 'Softmax' })), 'invalid-painters'],
    [file(smallModel({ channels: 129 })), 'slow-painters'],
    [large as any, 'large-painters'],
  ] as const) {
    await expect(add(given)).rejects.toMatchObject({ code });
  }
  expect(large.arrayBuffer).not.toHaveBeenCalled();
  expect([...models.value.keys()]).toEqual([id]);
  await open([file(noise, 'noise.onnx')]);
  expect(messages.failures.value).toEqual([
    expect.objectContaining({ name: 'noise.onnx', why: expect.stringMatching(/^this is not a model of painters: /) }),
  ]);
});

test('a dropped model goes to the first active painter of the open designer', async () => {
  const { open, change, draft, work, told } = app();
  await open([file(smallModel())]);
  expect([change.mock.calls, told()]).toEqual([
    [],
    ['Starry night.onnx is ready. Choose it in the Painter block of the style designer.'],
  ]);
  work.value = 'designer';
  const step = (block: string, bypass = false) => ({ key: 1, block, values: {}, bypass });
  draft.value = { background: [step('painter', true), step('etf')], foreground: [step('painter')] };
  await open([file(smallModel())]);
  expect(change.mock.calls).toEqual([
    [{ type: 'set', layer: 'foreground', at: 0, param: 'model', value: expect.stringMatching(/ Starry night\.onnx$/) }],
  ]);
});

test('a model can be removed, its style misses it, and the message brings it back', async () => {
  const { add, remove, missing, models, page, messages, name } = app();
  const reference = await add(file(smallModel()));
  page.value = { style: styleOf(reference) };
  expect(missing.value).toEqual([]);
  await remove(partsOf(reference).id);
  expect(missing.value).toEqual([reference]);
  expect(modelsOf(models.value, styleOf(reference))).toBe('');
  expect(Object.keys(await app(name).files([partsOf(reference).id]))).toEqual([]);
  messages.list.value.at(-1)?.way?.run();
  await vi.waitFor(() => expect(missing.value).toEqual([]));
  expect(modelsOf(models.value, styleOf(reference))).toBe(partsOf(reference).id);
});

test('without storage a model lasts until the app is closed, which is reported', async () => {
  const blocked = async () => Promise.reject(new Error('blocked'));
  const { add, told, models } = app('', { all: blocked, put: blocked, remove: blocked } as any);
  await add(file(smallModel()));
  expect([models.value.size, told()]).toEqual([
    1,
    ['Starry night.onnx works until you close the app, because the browser does not store it.'],
  ]);
});

test('references fit into the limit of the core, and bypassed blocks need no model', () => {
  const long = referenceOf('00112233445566ff', `${'東'.repeat(200)}\n.onnx`);
  expect(new TextEncoder().encode(long).length).toBeLessThanOrEqual(200);
  expect(core.checkStyle(JSON.stringify(styleOf(long)), 'own').background[0].model).toBe(long);
  const style = styleOf('00112233445566ff a.onnx');
  style.foreground = [{ block: 'painter', model: '0011223344556600 b.onnx', bypass: true }];
  expect(referencesIn(style)).toEqual(['00112233445566ff a.onnx']);
  expect(referencesIn('painter-night')).toEqual([]);
  expect(() => core.checkStyle(JSON.stringify(styleOf('a.onnx')), 'own')).toThrow('16 hexadecimal digits');
});
