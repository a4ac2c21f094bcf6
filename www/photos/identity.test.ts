import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { withoutMetadata } from '../engine/metadata/strip.ts';
import { loaded } from '../engine/metadata/testing.ts';
import { hashOf } from './identity.ts';

it('a photo is the same with what a telephone writes and without, and no other photo is', async () => {
  const [bee, cat] = await Promise.all(
    ['bee.jpg', 'cat.jpg'].map(async (name) =>
      loaded(new Blob([new Uint8Array(await readFile(new URL(`../../tests/photos/${name}`, import.meta.url)))])),
    ),
  );
  const { blob } = await withoutMetadata(bee);
  const [one, same, other] = await Promise.all([bee, blob, cat].map(hashOf));
  expect(one).toMatch(/^[0-9a-f]{64}$/);
  expect([same, other === one]).toEqual([one, false]);
  expect(await hashOf(new Blob([]))).toBe('');
});
