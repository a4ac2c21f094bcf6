import { afterEach, expect, test } from 'vitest';
import { readAssetsWith } from './assets.ts';
import { mentionsPainter, paintersLoader } from './painters.ts';

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

test('the model is given once, and loaded again after a failure', async () => {
  const answers = [new Response('', { status: 503 }), new Response(new Uint8Array([1, 2, 3]))];
  const asked: string[] = [];
  readAssetsWith(async (address) => {
    asked.push(String(address));
    return answers.shift() as Response;
  });
  const given: number[] = [];
  const load = paintersLoader((onnx) => given.push(onnx.length));
  await expect(load()).rejects.toMatchObject({ code: 'painters-missing' });
  await load();
  await load();
  expect(given).toEqual([3]);
  expect(asked).toHaveLength(2);
  expect(asked[0]).toContain('painters.onnx');
});
