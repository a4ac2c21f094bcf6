import { deflateRawSync } from 'node:zlib';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { ARCHIVE } from './limits.ts';
import { archiveOf, readArchive } from './archive.ts';
import { packedNothing, zipOf } from './testing-archives.ts';

const entry = (name: string, content: BlobPart) => ({ name, blob: new Blob([content]) });
const bytesOf = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer());

async function spoilt(archive: Blob, at: number, value: number) {
  const bytes = await bytesOf(archive);
  bytes[at] ^= value;
  return new Blob([bytes]);
}

describe('an archive', () => {
  it('gives back what was put in', async () => {
    await fc.assert(
      fc.asyncProperty(fc.dictionary(fc.string({ minLength: 1, unit: 'grapheme' }), fc.uint8Array()), async (files) => {
        const names = Object.keys(files);
        const found = await readArchive(
          await archiveOf(names.map((name) => entry(name, files[name] as Uint8Array<ArrayBuffer>))),
        );
        expect([...found.keys()].sort()).toEqual([...new Set(names)].sort());
        for (const name of names) expect(await bytesOf((await found.get(name)?.read()) as any)).toEqual(files[name]);
      }),
      { numRuns: 50 },
    );
  });

  it('may have been packed again by another program', async () => {
    const text = 'what was stored is deflated now'.repeat(9);
    const stored = await archiveOf([entry('a.txt', text)]);
    const packed = deflateRawSync(text);
    const bytes = await bytesOf(stored);
    const [local, central] = [bytes.slice(0, 35), bytes.slice(35 + text.length, -22)];
    for (const [part, method, size] of [
      [local, 8, 18],
      [central, 10, 20],
    ] as const) {
      new DataView(part.buffer).setUint16(method, 8, true);
      new DataView(part.buffer).setUint32(size, packed.length, true);
    }
    const end = bytes.slice(-22);
    new DataView(end.buffer).setUint32(16, 35 + packed.length, true);
    const found = await readArchive(new Blob([local, packed, central, end, 'x'.repeat(0)]));
    expect(await (await found.get('a.txt')?.read())?.text()).toBe(text);
  });

  it.each([
    ['nothing', ''],
    ['a photo', 'JFIF'.repeat(99)],
    ['half', null],
  ])('that is %s is refused', async (_, content) => {
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
      // A damaged file may be missing, but its content is never different.
      texts.forEach((text, i) => expect([undefined, good[i]]).toContain(text));
    }
  });

  it('of many entries, or of any method and kind that others write, is read', async () => {
    const files = [
      { name: 'a', content: Buffer.from('stored') },
      { name: 'b', content: Buffer.from('packed'), packed: true },
      // Its sizes follow after the data, as some programs write them.
      { name: 'c', content: Buffer.from('told later'), flags: 0x0808, local: { crc: 0, length: 0, size: 0 } },
      { name: 'folder/' },
      {
        name: 'd',
        content: Buffer.from('more about it'),
        extra: Buffer.from('UT\x05\0\x03abcd'),
        local: { extra: Buffer.from('UT\x01\0\x03') },
      },
    ];
    const found = await readArchive(new Blob([zipOf(files, { comment: 'a comment' })]));
    expect(
      await Promise.all(['a', 'b', 'c', 'd'].map(async (name) => (await found.get(name)?.read())?.text())),
    ).toEqual(['stored', 'packed', 'told later', 'more about it']);
  });
});

const [one, two] = [
  { name: 'a', content: Buffer.from('first') },
  { name: 'b', content: Buffer.from('second') },
];
/** Reads all of it, one after the other. */
async function readAll(file: Uint8Array<ArrayBuffer>) {
  const found = await readArchive(new Blob([file]));
  for (const { read } of found.values()) await read();
  return [...found.keys()];
}

// Unpacking takes longer on a busy machine.
describe('an archive that is a trap', { timeout: 60_000 }, () => {
  const nothing = packedNothing(64);
  const bomb = (name: string, size = 64 * 2 ** 20) => ({
    name,
    content: nothing,
    method: 8,
    length: nothing.length,
    size,
  });

  it.each([
    ['whose files claim the same bytes', () => zipOf([one, { ...one, name: 'b', at: 0, again: true }])],
    [
      'whose files overlap',
      () =>
        zipOf([
          { ...one, content: Buffer.concat([Buffer.from('x'), zipOf([two])]) },
          { ...two, at: 32, again: true },
        ]),
    ],
    ['whose file lies in its list of files', () => zipOf([one, { ...two, at: 36, again: true }])],
    ['with two files of one name', () => zipOf([one, { ...two, name: 'a' }])],
    ['of a file beyond its end', () => zipOf([one, { ...two, at: 0x7fffffff }])],
    ['of a file longer than the archive', () => zipOf([{ ...one, length: 0x7fffffff, size: 0x7fffffff }])],
    ['of a file that is 64-bit', () => zipOf([one, { ...two, length: 0xffffffff, size: 0xffffffff }])],
    ['that is 64-bit', () => zipOf([one], { count: 0xffff, start: 0xffffffff })],
    ['that counts in two ways', () => zipOf([one, two], { count: 1, total: 2 })],
    ['that says that it has more', () => zipOf([one, two], { count: 3 })],
    ['that says that it has less', () => zipOf([one, two], { count: 1 })],
    ['whose list of files reaches into its end', () => zipOf([one], { length: 60 })],
    ['that is encrypted', () => zipOf([one, { ...two, flags: 0x0801 }])],
    ['that only says inside that it is encrypted', () => zipOf([one, { ...two, local: { flags: 0x0801 } }])],
    ['that is packed in another way', () => zipOf([{ ...one, method: 14 }])],
    ['that says inside that it is packed', () => zipOf([{ ...one, local: { method: 8 } }])],
    ['with another name inside', () => zipOf([{ ...one, local: { name: 'project.json' } }])],
    ['with another length inside', () => zipOf([{ ...one, local: { length: 4 } }])],
    ['with another size inside', () => zipOf([{ ...one, local: { size: 4 } }])],
    ['with another checksum inside', () => zipOf([{ ...one, local: { crc: 4 } }])],
    [
      'whose head reaches into the next file',
      () =>
        zipOf([
          { name: 'a', local: { extra: zipOf([two]).subarray(0, 37) } },
          { ...two, at: 31, again: true },
        ]),
    ],
    ['that unpacks to more than it says', () => zipOf([bomb('a', 1000)])],
    ['that unpacks to less than it says', () => zipOf([bomb('a', 65 * 2 ** 20)])],
  ])('%s is refused', async (_, make) => {
    await expect(readAll(make())).rejects.toMatchObject({ code: 'damaged-project' });
  });

  it.each([
    ['too many files', () => zipOf(Array.from({ length: ARCHIVE.entries + 1 }, (_, i) => ({ name: `${i}` })))],
    ['a name that is too long', () => zipOf([{ ...one, name: 'a'.repeat(ARCHIVE.name + 1) }])],
    [
      'a list of files that is too long',
      () =>
        zipOf(
          Array.from({ length: 300 }, (_, i) => ({
            name: `${i}`,
            extra: Buffer.alloc(0xf000),
            local: { extra: Buffer.alloc(0) },
          })),
        ),
    ],
    ['a file that says that it unpacks to too much', () => zipOf([bomb('a', ARCHIVE.entry + 1)])],
    [
      'files that say that they unpack to too much together',
      () => zipOf('abcdefgh'.split('').map((name) => bomb(name))),
    ],
  ])('of %s is refused before anything is unpacked', async (_, make) => {
    await expect(readArchive(new Blob([make()]))).rejects.toMatchObject({ code: 'too-large-project' });
  });

  it('is not unpacked beyond what was asked for, whatever it says', async () => {
    const found = await readArchive(new Blob([zipOf([bomb('a'), { name: 'b', content: Buffer.alloc(99) }])]));
    const pieces = { count: 0 };
    await expect(found.get('a')?.read({ most: 1000, beat: () => (pieces.count += 1) })).rejects.toMatchObject({
      code: 'too-large-project',
    });
    expect(pieces.count).toBeLessThanOrEqual(1);
    await expect(found.get('b')?.read({ most: 98 })).rejects.toMatchObject({ code: 'too-large-project' });
    expect((await found.get('b')?.read({ most: 99 }))?.size).toBe(99);
  });

  it('is refused when its files were unpacked to too much together, whatever they say', async () => {
    const found = await readArchive(new Blob([zipOf('abcde'.split('').map((name) => bomb(name, 2 ** 20)))]));
    const reasons = [];
    // They unpack to more than stated, which is detected early.
    for (const { read } of found.values()) reasons.push(await read().catch(({ code }) => code));
    expect(reasons).toEqual(Array(5).fill('damaged-project'));
    const again = (await readArchive(new Blob([zipOf([bomb('a')])]))).get('a') as any;
    const codes = [];
    for (let i = 0; i < 5; i += 1)
      codes.push(
        await again.read().then(
          () => 'read',
          ({ code }: any) => code,
        ),
      );
    expect(codes).toEqual([
      'damaged-project',
      'damaged-project',
      'damaged-project',
      'damaged-project',
      'too-large-project',
    ]);
  });

  it('stops being read when nobody waits for it any more', async () => {
    const found = await readArchive(new Blob([zipOf([bomb('a')])]));
    const stop = new AbortController();
    let pieces = 0;
    const read = found.get('a')?.read({
      signal: stop.signal,
      beat: () => {
        if ((pieces += 1) === 3) stop.abort(new Error('enough'));
      },
    });
    await expect(read).rejects.toThrow('enough');
    expect(pieces).toBe(3);
  });

  it('is never written', async () => {
    const files = Array.from({ length: ARCHIVE.entries + 1 }, (_, i) => entry(`${i}`, ''));
    await expect(archiveOf(files)).rejects.toMatchObject({ code: 'too-large' });
  });
});
