// @ts-check
import { deflateRawSync } from 'node:zlib';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { archiveOf, readArchive } from './archive.js';

const entry = (/** @type {string} */ name, /** @type {BlobPart} */ content) => ({ name, blob: new Blob([content]) });
const bytesOf = async (/** @type {Blob} */ blob) => new Uint8Array(await blob.arrayBuffer());

/** @param {Blob} archive @param {number} at @param {number} value */
async function spoilt(archive, at, value) {
  const bytes = await bytesOf(archive);
  bytes[at] ^= value;
  return new Blob([bytes]);
}

describe('an archive', () => {
  it('gives back what was put in', async () => {
    await fc.assert(fc.asyncProperty(fc.dictionary(fc.string({ minLength: 1, unit: 'grapheme' }), fc.uint8Array()), async (files) => {
      const names = Object.keys(files);
      const found = await readArchive(await archiveOf(names.map((name) => entry(name, /** @type {Uint8Array<ArrayBuffer>} */ (files[name])))));
      expect([...found.keys()].sort()).toEqual([...new Set(names)].sort());
      for (const name of names) expect(await bytesOf(/** @type {any} */ (await found.get(name)?.read()))).toEqual(files[name]);
    }), { numRuns: 50 });
  });

  it('may have been packed again by another program', async () => {
    const text = 'what was stored is deflated now'.repeat(9);
    const stored = await archiveOf([entry('a.txt', text)]);
    const packed = deflateRawSync(text);
    const bytes = await bytesOf(stored);
    const [local, central] = [bytes.slice(0, 35), bytes.slice(35 + text.length, -22)];
    for (const [part, method, size] of /** @type {const} */ ([[local, 8, 18], [central, 10, 20]])) {
      new DataView(part.buffer).setUint16(method, 8, true);
      new DataView(part.buffer).setUint32(size, packed.length, true);
    }
    const end = bytes.slice(-22);
    new DataView(end.buffer).setUint32(16, 35 + packed.length, true);
    const found = await readArchive(new Blob([local, packed, central, end, 'x'.repeat(0)]));
    expect(await (await found.get('a.txt')?.read())?.text()).toBe(text);
  });

  it.each([['nothing', ''], ['a photo', 'JFIF'.repeat(99)], ['half', null]])('that is %s is refused', async (_, content) => {
    const whole = await archiveOf([entry('a', 'first'), entry('b', 'second')]);
    const file = content === null ? whole.slice(0, whole.size >> 1) : new Blob([content]);
    await expect(readArchive(file)).rejects.toMatchObject({ code: 'damaged-project' });
  });

  it('tells a changed byte, wherever it is', async () => {
    const whole = await archiveOf([entry('a', 'first'), entry('b', 'second')]);
    const good = ['first', 'second'];
    for (let at = 0; at < whole.size; at += 1) {
      const read = async () => {
        const found = await readArchive(await spoilt(whole, at, 0xff));
        return Promise.all(['a', 'b'].map(async (name) => (await found.get(name)?.read())?.text()));
      };
      const texts = await read().catch((error) => {
        expect(error.code).toBe('damaged-project');
        return good;
      });
      // A file may be gone with its name; none is ever another than it was.
      texts.forEach((text, i) => expect([undefined, good[i]]).toContain(text));
    }
  });
});
