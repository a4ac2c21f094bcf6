import { readFile } from 'node:fs/promises';
import { describe, expect, it, test } from 'vitest';
import { PNG } from '../../testing.ts';
import { chunkOf, chunksOf, dataOf, withChunks } from '../png-chunks.ts';
import { orientationOf, recordOf, withOrientation } from './exif.ts';
import { rotatedFile } from './rotate.ts';
import { loaded, record, segment } from './testing.ts';
import type { Rotation } from './rotate.ts';

const bytesOf = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer());
const textOf = async (blob: Blob) => Buffer.from(await blob.arrayBuffer()).toString('latin1');
const photo = async () =>
  new Blob([new Uint8Array(await readFile(new URL('../../../tests/photos/bee.jpg', import.meta.url)))]);

async function orientationIn(file: Blob): Promise<number> {
  const at = (await textOf(file)).indexOf('Exif\0\0');
  return at < 0 ? 1 : orientationOf((await bytesOf(file)).subarray(at + 6));
}

/** @returns where the orientation shows the upper left corner of the file, and its right neighbour */
function shown(orientation: number): string {
  const turned = [5, 6, 7, 8].includes(orientation);
  const right = [2, 3, 6, 7].includes(orientation);
  const bottom = [3, 4, 7, 8].includes(orientation);
  const corner = `${bottom ? 'bottom' : 'top'} ${right ? 'right' : 'left'}`;
  return `${corner}, ${turned ? (bottom ? 'up' : 'down') : right ? 'left' : 'right'}`;
}

/** The description of a picture after it is rotated or flipped. */
function expected(before: string, rotation: Rotation): string {
  const corners = {
    right: {
      'top left': 'top right',
      'top right': 'bottom right',
      'bottom right': 'bottom left',
      'bottom left': 'top left',
    },
    flip: {
      'top left': 'top right',
      'top right': 'top left',
      'bottom right': 'bottom left',
      'bottom left': 'bottom right',
    },
  };
  const ways = {
    right: { right: 'down', down: 'left', left: 'up', up: 'right' },
    flip: { right: 'left', left: 'right', up: 'up', down: 'down' },
  };
  const [corner, way] = before.split(', ');
  const to = (table: object, word: string) => (table as Record<string, string>)[word];
  return `${to(corners[rotation], corner)}, ${to(ways[rotation], way)}`;
}

test.each(['right', 'flip'] as const)('%s turns all eight orientations', async (rotation) => {
  for (let orientation = 1; orientation <= 8; orientation += 1) {
    const plain = await photo();
    const file = new Blob([plain.slice(0, 2), segment(0xe1, 'Exif\0\0', recordOf(orientation)), plain.slice(2)]);
    const after = await orientationIn((await rotatedFile(file, rotation)) as Blob);
    expect([orientation, shown(after)]).toEqual([orientation, expected(shown(orientation), rotation)]);
  }
});

describe('a rotated JPEG', () => {
  it('has its metadata and pixels, byte by byte', async () => {
    const file = loaded(await photo());
    const rotated = (await rotatedFile(file, 'right')) as Blob;
    const [before, after] = [await bytesOf(file), await bytesOf(rotated)];
    expect(after.length).toBe(before.length);
    expect(after.filter((byte, i) => byte !== before[i]).length).toBe(1);
    expect([await orientationIn(file), await orientationIn(rotated)]).toEqual([6, 3]);
  });

  it('gets a record after its first segment, if it has none', async () => {
    const file = await photo();
    const once = (await rotatedFile(file, 'right')) as Blob;
    expect(await orientationIn(once)).toBe(6);
    expect((await bytesOf(once)).slice(0, 4)).toEqual((await bytesOf(file)).slice(0, 4));
    let back = once;
    for (let i = 0; i < 3; i += 1) back = (await rotatedFile(back, 'right')) as Blob;
    expect([await orientationIn(back), back.size]).toEqual([1, once.size]);
  });
});

test.each([true, false])('a record without an orientation keeps its fields (little endian: %s)', (little) => {
  const before = record({ little });
  const tag = little ? [0x12, 0x01] : [0x01, 0x12];
  const at = before.findIndex((byte, i) => byte === tag[0] && before[i + 1] === tag[1]);
  // Another field, of the same length, between the same two.
  before.set(little ? [0x11, 0x01] : [0x01, 0x11], at);
  expect(orientationOf(before)).toBe(1);
  const after = withOrientation(before, 8) as Uint8Array;
  expect(orientationOf(after)).toBe(8);
  const view = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset);
  const tags = (bytes: Uint8Array) => {
    const start = view(bytes).getUint32(4, little);
    const count = view(bytes).getUint16(start, little);
    return Array.from({ length: count }, (_, i) => view(bytes).getUint16(start + 2 + 12 * i, little));
  };
  expect(tags(after)).toEqual([...tags(before), 0x112].sort((one, other) => one - other));
});

test('a PNG gets another orientation, and nothing else changes', async () => {
  const png = new PNG({ width: 3, height: 2 });
  const plain = new Blob([new Uint8Array(PNG.sync.write(png))]);
  const file = await withChunks(plain, { before: [await chunkOf('eXIf', record({ orientation: 2 }))] });
  for (const [from, orientation] of [
    [plain, 6],
    [file, 7],
  ] as const) {
    const rotated = (await rotatedFile(from, 'right')) as Blob;
    const chunks = (await chunksOf(rotated)) ?? [];
    expect(chunks.map(({ type }) => type)).toEqual(['IHDR', 'eXIf', 'IDAT', 'IEND']);
    const data = (await dataOf(rotated, chunks[1])) as Blob;
    expect(orientationOf(await bytesOf(data))).toBe(orientation);
  }
});

test('other files have no orientation', async () => {
  expect(await rotatedFile(new Blob(['GIF89a']), 'right')).toBe(null);
  expect(await rotatedFile(new Blob([]), 'flip')).toBe(null);
  expect(await rotatedFile(new Blob([Uint8Array.of(0xff, 0xd8, 0x00, 0xe1, 0, 4)]), 'flip')).toBe(null);
});
