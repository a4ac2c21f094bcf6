import { describe, expect, it } from 'vitest';
import { chunk, chunksOf, fileOf } from '../engine/webp.ts';
import { animatedWebp, changesOf } from './animated-webp.ts';

const bytes = async (file: Blob) => new Uint8Array(await file.arrayBuffer());

/** A picture as a browser encodes one with alpha. */
async function still(pixels: number[]) {
  const head = new Uint8Array(10);
  return bytes(
    fileOf([
      chunk('VP8X', head),
      chunk('ALPH', Uint8Array.from([1, 2, 3])),
      chunk('VP8 ', Uint8Array.from(pixels)),
      chunk('EXIF', Uint8Array.from([9])),
    ]),
  );
}

describe('an animated WebP file', () => {
  it('has of a picture the pixels that are new', () => {
    const before = Uint8ClampedArray.from([1, 2, 3, 255, 4, 5, 6, 255]);
    const picture = Uint8ClampedArray.from([1, 2, 3, 255, 4, 5, 7, 255]);
    expect([...changesOf(picture, before)]).toEqual([0, 0, 0, 0, 4, 5, 7, 255]);
  });

  it('shows of later pictures what is new, over those before', async () => {
    const frames = [await still([1]), await still([2])];
    const file = await bytes(animatedWebp(frames, { width: 4, height: 2 }, 83, true));
    const [, , first, second] = chunksOf(file);
    expect([first.data[15], second.data[15]]).toEqual([2, 0]);
  });

  it('has a frame for each picture, with its pixels alone, as large and as long as told', async () => {
    const frames = [await still([7, 7, 7, 7]), await still([8, 8, 8])];
    const file = await bytes(animatedWebp(frames, { width: 300, height: 2 }, 83));
    expect(new TextDecoder().decode(file.subarray(0, 4))).toBe('RIFF');
    expect(new DataView(file.buffer).getUint32(4, true)).toBe(file.length - 8);
    const [head, animation, ...parts] = chunksOf(file);
    expect([head.name, [...head.data]]).toEqual(['VP8X', [0x12, 0, 0, 0, 43, 1, 0, 1, 0, 0]]);
    expect([animation.name, [...animation.data]]).toEqual(['ANIM', [0, 0, 0, 0, 0, 0]]);
    expect(parts.map(({ name }) => name)).toEqual(['ANMF', 'ANMF']);
    const [first] = parts;
    expect([...first.data.subarray(0, 16)]).toEqual([0, 0, 0, 0, 0, 0, 43, 1, 0, 1, 0, 0, 83, 0, 0, 2]);
    const inside = chunksOf(Uint8Array.from([...new Uint8Array(12), ...first.data.subarray(16)]));
    expect(inside.map(({ name, data }) => [name, [...data]])).toEqual([
      ['ALPH', [1, 2, 3]],
      ['VP8 ', [7, 7, 7, 7]],
    ]);
  });
});
