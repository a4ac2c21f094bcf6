import { afterEach, expect, test, vi } from 'vitest';
import { readAssetsWith } from './assets.ts';
import { mentionsPainter, ownModelsIn, paintersLoader, withOwnModels } from './painters.ts';

afterEach(() => readAssetsWith((address) => fetch(address)));

test('jobs with a painter are found by block and by style', () => {
  for (const args of [
    'painter-night',
    '{"background":[{"block":"painter","painter":2}]}',
    { document: '{"style":"painter-night","panels":[]}' },
    { asks: [{ style: { background: [{ block: 'sobel' }, { block: 'painter' }] } }] },
    [{ style: 'noir' }, { style: 'painter-wave' }],
  ]) {
    expect(mentionsPainter(args), JSON.stringify(args)).toBe(true);
  }
  for (const args of [
    'noir',
    null,
    12,
    { document: '{"style":"house-painter","title":"The painter"}' },
    { data: new TextEncoder().encode('"painter"'), file: new Blob(['"painter"']) },
  ]) {
    expect(mentionsPainter(args), JSON.stringify(args)).toBe(false);
  }
});

const studio = () => ({ know_painters: vi.fn(), know_own_painters: vi.fn(), forget_own_painters: vi.fn() });
const OWN = '00112233445566ff';
const STYLE = `{"background":[{"block":"painter","painter":2,"model":"${OWN} mine.onnx"}]}`;

test('the built-in model is given once, and loaded again after a failure', async () => {
  const answers = [new Response('', { status: 503 }), new Response(new Uint8Array([1, 2, 3]))];
  const asked: string[] = [];
  readAssetsWith(async (address) => {
    asked.push(String(address));
    return answers.shift() as Response;
  });
  const module = studio();
  const load = paintersLoader(module);
  await expect(load('painter-night')).rejects.toMatchObject({ code: 'painters-missing' });
  await load('painter-night');
  await load('painter-night');
  expect(module.know_painters.mock.calls).toEqual([[Uint8Array.of(1, 2, 3)]]);
  expect(asked).toHaveLength(2);
  expect(asked[0]).toContain('painters.onnx');
});

test('models of the user are found in styles and documents, and come with the job', async () => {
  for (const args of [{ style: STYLE }, { styles: ['{}', STYLE] }, { asks: [{ style: JSON.parse(STYLE) }] }]) {
    expect(ownModelsIn(args)).toEqual([OWN]);
  }
  expect(
    ownModelsIn({ style: '{"background":[{"block":"painter"}]}', model: 'none', file: new Blob([STYLE]) }),
  ).toEqual([]);
  const find = vi.fn(async (ids: readonly string[]) => ({ [ids[0]]: new Blob(['m']) }));
  expect(await withOwnModels({ style: STYLE }, find)).toEqual({ style: STYLE, own: { [OWN]: expect.any(Blob) } });
  const plain = { style: 'noir' };
  expect(await withOwnModels(plain, find)).toBe(plain);
  expect(find.mock.calls).toEqual([[[OWN]]]);
});

test('a worker reads a model of the user once, also offline, and forgets one that was removed', async () => {
  readAssetsWith(async () => new Response('', { status: 503 }));
  const module = studio();
  const load = paintersLoader(module);
  const job = { style: STYLE, own: { [OWN]: new Blob([Uint8Array.of(7)]) } };
  await load(job);
  await load(job);
  expect(module.know_own_painters.mock.calls).toEqual([[OWN, Uint8Array.of(7)]]);
  expect(module.forget_own_painters).not.toHaveBeenCalled();
  readAssetsWith(async () => new Response(Uint8Array.of(1)));
  await load({ style: STYLE });
  expect(module.forget_own_painters).toHaveBeenCalledOnce();
  await load(job);
  expect(module.know_own_painters).toHaveBeenCalledTimes(2);
});
