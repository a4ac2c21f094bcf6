import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { archiveNames } from './archive-names.ts';
import { readAssetsFromFiles } from './testing-assets.ts';

readAssetsFromFiles();

const bytes = (...values: number[]) => Uint8Array.from(values);
const text = (name: string) => new TextEncoder().encode(name);
const jpg = [0x2e, 0x6a, 0x70, 0x67];

describe('names of files in an archive', () => {
  test('are UTF-8 if they can be', async () => {
    expect(await archiveNames([text('ä.jpg'), text('写真/1.jpg')])).toEqual(['ä.jpg', '写真/1.jpg']);
  });

  // Bytes of Python: 'あ.jpg'.encode('shift_jis'), 'è.jpg'.encode('cp437') and so on.
  test('of Japanese systems are Shift-JIS', async () => {
    const names = [bytes(0x82, 0xa0, ...jpg), bytes(0x82, 0xa2, ...jpg), text('a.jpg')];
    expect(await archiveNames(names)).toEqual(['あ.jpg', 'い.jpg', 'a.jpg']);
  });

  test('of other systems are code page 437', async () => {
    const names = [bytes(0x8a, ...jpg), bytes(0x81, ...jpg), bytes(0xe1, ...jpg)];
    expect(await archiveNames(names)).toEqual(['è.jpg', 'ü.jpg', 'ß.jpg']);
  });

  test('are different if their bytes are different', async () => {
    await fc.assert(
      fc.asyncProperty(
        fc.uniqueArray(fc.uint8Array({ minLength: 1, maxLength: 6 }), { selector: String }),
        async (names) => {
          expect(new Set(await archiveNames(names)).size).toBe(names.length);
        },
      ),
      { numRuns: 300 },
    );
  });
});
