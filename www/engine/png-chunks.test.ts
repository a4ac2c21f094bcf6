import { crc32 } from 'node:zlib';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { PNG } from '../testing.ts';
import { crcOf } from './crc.ts';
import { chunkOf, chunksOf, dataOf, isPng, pngOf, textChunk, textHead, textOf, withChunks } from './png-chunks.ts';

/** A picture of random colours, in several chunks of pixels. */
const drawn = () => {
  const png = new PNG({ width: 40, height: 30 });
  for (let i = 0; i < png.data.length; i += 1) png.data[i] = (i * 7919) % 256;
  return new Blob([new Uint8Array(PNG.sync.write(png))], { type: 'image/png' });
};
const types = async (file: Blob) => (await chunksOf(file))?.map(({ type }) => type);

async function read(file: Blob, keyword: string) {
  for (const chunk of (await chunksOf(file)) ?? []) {
    if (chunk.type !== 'iTXt') continue;
    const data = await dataOf(file, chunk);
    const head = data && (await textHead(data));
    if (head?.keyword === keyword) return textOf(head, 1 << 20);
  }
  return undefined;
}

describe('chunks of a PNG', () => {
  it('are put in around the pixels, which stay', async () => {
    const file = drawn();
    const more = await withChunks(file, {
      before: [await textChunk('inkpanel', 'of before')],
      after: [await chunkOf('ipPh', new Uint8Array(99))],
    });
    expect(await types(file)).toEqual(['IHDR', 'IDAT', 'IEND']);
    expect(await types(more)).toEqual(['IHDR', 'iTXt', 'IDAT', 'ipPh', 'IEND']);
    const decode = async (blob: Blob) => PNG.sync.read(Buffer.from(await blob.arrayBuffer())).data;
    // An independent reader checks every chunk.
    expect(await decode(more)).toEqual(await decode(file));
  });

  it('hold any text', async () => {
    await fc.assert(
      fc.asyncProperty(fc.string({ unit: 'grapheme' }), async (text) => {
        const file = await withChunks(drawn(), {
          before: [await textChunk('other', 'x'), await textChunk('inkpanel', text)],
        });
        expect(await read(file, 'inkpanel')).toBe(text);
      }),
      { numRuns: 40 },
    );
  });

  it('have the checksum of zlib', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 300 }), async (bytes) => {
        expect(await crcOf(new Blob([bytes as Uint8Array<ArrayBuffer>]))).toBe(crc32(bytes));
      }),
    );
  });

  it('that are broken are told, wherever the byte', async () => {
    const file = await withChunks(drawn(), { before: [await textChunk('inkpanel', 'a text')] });
    const bytes = new Uint8Array(await file.arrayBuffer());
    const [, text] = (await chunksOf(file)) ?? [];
    for (let at = text.at - 8; at < text.at + text.length + 4; at += 1) {
      const spoilt = bytes.slice();
      spoilt[at] ^= 0x20;
      expect([undefined, null]).toContain(await read(new Blob([spoilt]), 'inkpanel'));
    }
    for (const end of [0, 3, 8, 20, bytes.length - 1]) expect(await chunksOf(file.slice(0, end))).toBe(null);
  });

  it('do not unpack beyond what is allowed', async () => {
    const chunk = await textChunk('inkpanel', '0'.repeat(30 << 20));
    expect(chunk.size).toBeLessThan(40_000);
    expect(await read(await withChunks(drawn(), { before: [chunk] }), 'inkpanel')).toBe(null);
  });

  it('are told by the content alone', async () => {
    expect(await isPng(drawn())).toBe(true);
    expect(await isPng(new Blob(['\x89PNG']))).toBe(false);
    expect(await isPng(new Blob([]))).toBe(false);
    expect(await types(pngOf([await chunkOf('IEND', new Blob([]))]))).toEqual(['IEND']);
  });

  it('survive bytes of any kind', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 400 }), async (tail) => {
        const found = await chunksOf(pngOf([new Blob([tail as Uint8Array<ArrayBuffer>])]));
        expect(found === null || found.length > 0).toBe(true);
      }),
    );
  });
});
