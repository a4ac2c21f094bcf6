// @ts-check
import { readFile } from 'node:fs/promises';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { PNG } from '../../testing.js';
import { chunkOf, chunksOf, textChunk, wholeChunk, withChunks } from '../png-chunks.js';
import { orientationOf } from './exif.js';
import { withoutMetadata } from './strip.js';
import { SECRETS, box, loaded, record, segment } from './testing.js';

const bytesOf = async (/** @type {Blob} */ blob) => new Uint8Array(await blob.arrayBuffer());
const textOf = async (/** @type {Blob} */ blob) => Buffer.from(await blob.arrayBuffer()).toString('latin1');
const photo = async () => new Blob([new Uint8Array(await readFile(new URL('../../../tests/photos/bee.jpg', import.meta.url)))], { type: 'image/jpeg' });

/** Strips, and checks what holds of every kind of file. @param {Blob} file */
async function stripped(file) {
  const { blob, clean } = await withoutMetadata(file);
  const text = await textOf(blob);
  for (const secret of SECRETS) expect(text).not.toContain(secret);
  expect([clean, blob.type]).toEqual([true, file.type]);
  const again = await withoutMetadata(blob);
  expect(await bytesOf(again.blob)).toEqual(await bytesOf(blob));
  return { blob, text };
}

describe('what is taken out', () => {
  it('of a JPEG is all but its pixels, their colours and which side is up', async () => {
    const plain = await bytesOf((await withoutMetadata(await photo())).blob);
    const profile = segment(0xe2, 'ICC_PROFILE\0\x01\x01colours');
    const file = loaded(new Blob([await photo().then((blob) => blob.slice(0, 2)), profile, (await photo()).slice(2)]));
    expect(await textOf(file)).toContain('SECRET place');
    const { blob, text } = await stripped(new Blob([file], { type: 'image/jpeg' }));
    expect(text).toContain('ICC_PROFILE');
    const at = text.indexOf('Exif\0\0');
    const bytes = await bytesOf(blob);
    expect(orientationOf(bytes.subarray(at + 6))).toBe(6);
    // All tables and all coded pixels, to the last byte.
    const tables = (/** @type {Uint8Array} */ of) => Buffer.from(of).subarray(Buffer.from(of).indexOf(Buffer.from([0xff, 0xdb])));
    expect(tables(bytes).equals(tables(plain))).toBe(true);
  });

  it('of a JPEG that says nothing is nothing', async () => {
    const file = await photo();
    const once = await withoutMetadata(file);
    expect(await bytesOf((await withoutMetadata(once.blob)).blob)).toEqual(await bytesOf(once.blob));
    expect(once.blob.size).toBeLessThanOrEqual(file.size);
  });

  it('of a PNG is all but what its colours need', async () => {
    const png = new PNG({ width: 9, height: 7 });
    png.data.fill(90);
    const plain = new Blob([new Uint8Array(PNG.sync.write(png))], { type: 'image/png' });
    const before = [
      await textChunk('inkpanel', 'SECRET'), await chunkOf('tEXt', new Blob(['Author\0SECRET'])), await chunkOf('tIME', new Uint8Array(7)),
      await chunkOf('eXIf', record({ little: false })), await chunkOf('gAMA', Uint8Array.of(0, 0, 0xb1, 0x8f)),
    ];
    const file = new Blob([await withChunks(plain, { before, after: [await chunkOf('ipPh', new Blob(['SECRET']))] }), 'SECRET'], { type: 'image/png' });
    const { blob } = await stripped(file);
    const chunks = await chunksOf(blob) ?? [];
    expect(chunks.map(({ type }) => type)).toEqual(['IHDR', 'eXIf', 'gAMA', 'IDAT', 'IEND']);
    expect(orientationOf((await bytesOf(wholeChunk(blob, chunks[1]))).slice(8))).toBe(6);
    expect(PNG.sync.read(Buffer.from(await bytesOf(blob))).data).toEqual(png.data);
  });

  it.each([[6, 0x08 | 0x20, true], [1, 0x20, false]])('of a WebP with orientation %i leaves flags that are true', async (orientation, flags, keeps) => {
    const part = (/** @type {string} */ type, /** @type {Uint8Array<ArrayBuffer> | string} */ content) => {
      const body = new Blob([content]);
      return new Blob([type, Uint8Array.of(body.size & 0xff, body.size >> 8, 0, 0), body, body.size % 2 ? '\0' : '']);
    };
    const size = (/** @type {Blob} */ body) => Uint8Array.of(body.size & 0xff, body.size >> 8, 0, 0);
    const body = new Blob(['WEBP', part('VP8X', Uint8Array.of(0x2c, 0, 0, 0, 7, 0, 0, 7, 0, 0)), part('ICCP', 'abc'), part('VP8 ', 'pixel'), part('EXIF', record({ orientation })), part('XMP ', 'SECRET')]);
    const { blob, text } = await stripped(new Blob(['RIFF', size(body), body], { type: 'image/webp' }));
    const bytes = await bytesOf(blob);
    expect(new DataView(bytes.buffer).getUint32(4, true)).toBe(bytes.length - 8);
    expect([bytes[20], text.includes('EXIF'), text.includes('ICCP'), text.includes('pixel')]).toEqual([flags, keeps, true, true]);
    if (keeps) expect(orientationOf(bytes.subarray(text.indexOf('EXIF') + 8))).toBe(6);
  });

  it('of a GIF is what is not drawn', async () => {
    const blocks = (/** @type {string} */ text) => `${String.fromCharCode(text.length)}${text}\0`;
    const head = Uint8Array.of(2, 0, 2, 0, 0x80, 0, 0, 1, 2, 3, 4, 5, 6);
    const image = Uint8Array.of(0x2c, 0, 0, 0, 0, 2, 0, 2, 0, 0, 2, 2, 0x44, 0x01, 0);
    const extension = (/** @type {number} */ label, /** @type {string} */ content) => new Blob([Uint8Array.of(0x21, label), content]);
    const loops = extension(0xff, `${String.fromCharCode(11)}NETSCAPE2.0${blocks('\x01\x00\x00')}`);
    const xmp = extension(0xff, `${String.fromCharCode(11)}XMP DataXMP${blocks('SECRET')}`);
    const file = new Blob(['GIF89a', head, loops, extension(0xfe, blocks('SECRET')), xmp, image, ';', 'SECRET']);
    const { blob } = await stripped(file);
    expect(await bytesOf(blob)).toEqual(await bytesOf(new Blob(['GIF89a', head, loops, image, ';'])));
  });

  it.each([true, false])('of a TIFF is blanked where it stands, little end first: %s', async (little) => {
    const file = record({ little, pixels: true });
    const { blob } = await stripped(new Blob([file]));
    const bytes = await bytesOf(blob);
    expect([bytes.length, orientationOf(bytes), [...bytes.subarray(1200, 1204)]]).toEqual([file.length, 6, [11, 22, 33, 44]]);
    const view = new DataView(bytes.buffer);
    const tags = Array.from({ length: view.getUint16(8, little) }, (_, i) => view.getUint16(10 + 12 * i, little));
    expect(tags).toEqual([256, 257, 258, 259, 262, 273, 274, 277, 278, 279]);
  });

  it('of a HEIC is blanked among its items', async () => {
    const pixels = Uint8Array.from({ length: 999 }, (_, i) => (i * 31) % 251);
    const items = box('mdat', Uint8Array.of(0, 0, 0, 6), 'Exif\0\0', record({ little: false }), pixels, '<?xpacket begin="x"?>SECRET<?xpacket end="w"?>');
    const file = new Blob([box('ftyp', 'heic\0\0\0\0mif1heic'), box('meta', 'items and where they are'), items], { type: 'image/heic' });
    const { blob, text } = await stripped(file);
    expect([blob.size, text.includes('items and where they are')]).toEqual([file.size, true]);
    expect(Buffer.from(await bytesOf(blob)).includes(Buffer.from(pixels))).toBe(true);
    expect(orientationOf((await bytesOf(blob)).subarray(text.indexOf('MM\0*')))).toBe(6);
  });

  it('of a film is what it tells beside its tracks', async () => {
    const dated = Uint8Array.of(0, 0, 0, 0, ...[...'SECRETxx'].map((letter) => letter.charCodeAt(0)), 0, 0, 3, 232);
    const track = box('trak', box('tkhd', dated), box('mdia', box('mdhd', dated), box('hdlr', '\0\0\0\0\0\0\0\0vide')), box('udta', 'SECRET'));
    const file = new Blob([box('ftyp', 'isom'), box('moov', box('mvhd', dated), track, box('meta', 'SECRET'), box('udta', 'SECRET +46.2+003.1/')), box('mdat', 'pictures')], { type: 'video/mp4' });
    const { blob, text } = await stripped(file);
    expect([blob.size, text.includes('pictures'), text.split('free').length - 1]).toEqual([file.size, true, 3]);
    const told = new Blob([box('ftyp', 'isom'), box('moov', box('trak', box('mdia', box('hdlr', '\0\0\0\0\0\0\0\0meta'))))]);
    expect((await withoutMetadata(told)).clean).toBe(false);
  });

  it('is said not to be out where it cannot be', async () => {
    for (const file of [new Blob(['what is this?']), new Blob([]), (await photo()).slice(0, 2000), new Blob([Uint8Array.of(0x1a, 0x45, 0xdf, 0xa3)])]) {
      const { blob, clean } = await withoutMetadata(file);
      expect([blob, clean]).toEqual([file, false]);
    }
  });

  it('survives bytes of any kind', async () => {
    const starts = ['\xff\xd8\xff', '\x89PNG\r\n\x1a\n', 'RIFF\x20\0\0\0WEBP', 'GIF89a', 'BM', 'II*\0\x08\0\0\0', 'MM\0*\0\0\0\x08', '\0\0\0\x10ftypheic\0\0\0\0', '\0\0\0\x10ftypisom\0\0\0\0'];
    await fc.assert(fc.asyncProperty(fc.constantFrom(...starts), fc.uint8Array({ maxLength: 300 }), async (start, tail) => {
      const file = new Blob([Uint8Array.from([...start].map((letter) => letter.charCodeAt(0))), /** @type {Uint8Array<ArrayBuffer>} */ (tail)]);
      const { blob } = await withoutMetadata(file);
      expect(await bytesOf((await withoutMetadata(blob)).blob)).toEqual(await bytesOf(blob));
    }), { numRuns: 400 });
  });
});
