import { readFile, readdir } from 'node:fs/promises';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { PNG } from '../../testing.ts';
import { chunkOf, chunksOf, textChunk, wholeChunk, withChunks } from '../png-chunks.ts';
import { orientationOf } from './exif.ts';
import { withoutMetadata } from './strip.ts';
import { SECRETS, box, bytesOf as joined, heic, loaded, record, segment, soiled } from './testing.ts';

const bytesOf = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer());
const textOf = async (blob: Blob) => Buffer.from(await blob.arrayBuffer()).toString('latin1');
const photo = async () =>
  new Blob([new Uint8Array(await readFile(new URL('../../../tests/photos/bee.jpg', import.meta.url)))], {
    type: 'image/jpeg',
  });

/** Strips, and checks what holds of every kind of file. */
async function stripped(file: Blob) {
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
    const tables = (of: Uint8Array) => Buffer.from(of).subarray(Buffer.from(of).indexOf(Buffer.from([0xff, 0xdb])));
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
      await textChunk('inkpanel', 'SECRET'),
      await chunkOf('tEXt', new Blob(['Author\0SECRET'])),
      await chunkOf('tIME', new Uint8Array(7)),
      await chunkOf('eXIf', record({ little: false })),
      await chunkOf('gAMA', Uint8Array.of(0, 0, 0xb1, 0x8f)),
    ];
    const file = new Blob(
      [await withChunks(plain, { before, after: [await chunkOf('ipPh', new Blob(['SECRET']))] }), 'SECRET'],
      { type: 'image/png' },
    );
    const { blob } = await stripped(file);
    const chunks = (await chunksOf(blob)) ?? [];
    expect(chunks.map(({ type }) => type)).toEqual(['IHDR', 'eXIf', 'gAMA', 'IDAT', 'IEND']);
    expect(orientationOf((await bytesOf(wholeChunk(blob, chunks[1]))).slice(8))).toBe(6);
    expect(PNG.sync.read(Buffer.from(await bytesOf(blob))).data).toEqual(png.data);
  });

  it.each([
    [6, 0x08 | 0x20, true],
    [1, 0x20, false],
  ])('of a WebP with orientation %i leaves flags that are true', async (orientation, flags, keeps) => {
    const part = (type: string, content: Uint8Array<ArrayBuffer> | string) => {
      const body = new Blob([content]);
      return new Blob([type, Uint8Array.of(body.size & 0xff, body.size >> 8, 0, 0), body, body.size % 2 ? '\0' : '']);
    };
    const size = (body: Blob) => Uint8Array.of(body.size & 0xff, body.size >> 8, 0, 0);
    const body = new Blob([
      'WEBP',
      part('VP8X', Uint8Array.of(0x2c, 0, 0, 0, 7, 0, 0, 7, 0, 0)),
      part('ICCP', 'abc'),
      part('VP8 ', 'pixel'),
      part('EXIF', record({ orientation })),
      part('XMP ', 'SECRET'),
    ]);
    const { blob, text } = await stripped(new Blob(['RIFF', size(body), body], { type: 'image/webp' }));
    const bytes = await bytesOf(blob);
    expect(new DataView(bytes.buffer).getUint32(4, true)).toBe(bytes.length - 8);
    expect([bytes[20], text.includes('EXIF'), text.includes('ICCP'), text.includes('pixel')]).toEqual([
      flags,
      keeps,
      true,
      true,
    ]);
    if (keeps) expect(orientationOf(bytes.subarray(text.indexOf('EXIF') + 8))).toBe(6);
  });

  it('of a GIF is what is not drawn', async () => {
    const blocks = (text: string) => `${String.fromCharCode(text.length)}${text}\0`;
    const head = Uint8Array.of(2, 0, 2, 0, 0x80, 0, 0, 1, 2, 3, 4, 5, 6);
    const image = Uint8Array.of(0x2c, 0, 0, 0, 0, 2, 0, 2, 0, 0, 2, 2, 0x44, 0x01, 0);
    const extension = (label: number, content: string) => new Blob([Uint8Array.of(0x21, label), content]);
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
    expect([bytes.length, orientationOf(bytes), [...bytes.subarray(1200, 1204)]]).toEqual([
      file.length,
      6,
      [11, 22, 33, 44],
    ]);
    const view = new DataView(bytes.buffer);
    const tags = Array.from({ length: view.getUint16(8, little) }, (_, i) => view.getUint16(10 + 12 * i, little));
    expect(tags).toEqual([256, 257, 258, 259, 262, 273, 274, 277, 278, 279]);
  });

  it.each([
    { version: 0 },
    { version: 1 },
    { version: 2 },
    { version: 1, inside: true },
    { version: 1, orientation: 1 },
  ])('of a HEIC is blanked among its items: %j', async (how) => {
    const { file, pixels } = heic(how);
    const { blob } = await stripped(new Blob([file], { type: 'image/heic' }));
    const bytes = Buffer.from(await bytesOf(blob));
    for (const picture of pixels)
      expect(bytes.indexOf(Buffer.from(picture))).toBe(Buffer.from(file).indexOf(Buffer.from(picture)));
    expect(orientationOf(bytes.subarray(bytes.indexOf('II*\0')))).toBe(how.orientation ?? 6);
    const text = bytes.toString('latin1');
    expect(
      ['ispe', 'irot', 'ipma', 'pict', 'hvc1', 'application/rdf+xml', 'udes', 'uuid', 'mpvd'].map((word) =>
        text.includes(word),
      ),
    ).toEqual([true, true, true, true, true, true, false, false, false]);
    expect(bytes.length).toBe(Buffer.from(file).indexOf(Buffer.from('free')) - 4);
  });

  it('of a HEIC whose records and pictures are the same bytes is said to be in', async () => {
    const { file } = heic();
    // The location of the metadata is the location of an image.
    const at = Buffer.from(file).indexOf(Buffer.from('iloc')) + 8 + 4;
    const view = new DataView(file.buffer);
    const picture = view.getUint32(at + 8);
    const other = Buffer.from(file).indexOf(Buffer.from([0, 4, 0, 0, 0, 0, 0, 1]), at);
    view.setUint32(other + 8, picture);
    const { blob, clean } = await withoutMetadata(new Blob([file]));
    expect(clean).toBe(false);
    expect((await bytesOf(blob)).subarray(picture, picture + 400)).toEqual(file.subarray(picture, picture + 400));
  });

  it('of a film is what it tells beside its tracks', async () => {
    const dated = Uint8Array.of(0, 0, 0, 0, ...[...'SECRETxx'].map((letter) => letter.charCodeAt(0)), 0, 0, 3, 232);
    const track = box(
      'trak',
      box('tkhd', dated),
      box('mdia', box('mdhd', dated), box('hdlr', '\0\0\0\0\0\0\0\0vide')),
      box('udta', 'SECRET'),
    );
    const file = new Blob(
      [
        box('ftyp', 'isom'),
        box('moov', box('mvhd', dated), track, box('meta', 'SECRET'), box('udta', 'SECRET +46.2+003.1/')),
        box('mdat', 'pictures'),
      ],
      { type: 'video/mp4' },
    );
    const { blob, text } = await stripped(file);
    expect([blob.size, text.includes('pictures'), text.split('free').length - 1]).toEqual([file.size, true, 3]);
    const told = new Blob([
      box('ftyp', 'isom'),
      box('moov', box('trak', box('mdia', box('hdlr', '\0\0\0\0\0\0\0\0meta')))),
    ]);
    expect((await withoutMetadata(told)).clean).toBe(false);
  });

  it('of a film is what no player needs, wherever it lies', async () => {
    const coded = joined(
      new Uint8Array(12),
      'SECR',
      new Uint8Array(26),
      'SECRET coder'.padEnd(32),
      [0, 24, 255, 255],
      box('avcC', 'how'),
    );
    const tables = box(
      'stbl',
      box('stsd', joined([0, 0, 0, 0, 0, 0, 0, 1]), box('avc1', coded)),
      box('stco', 'where'),
      box('SECR', 'SECRET'),
    );
    const places = box(
      'dinf',
      box('dref', joined([0, 0, 0, 0, 0, 0, 0, 1]), box('alis', joined([0, 0, 0, 1], 'SECRET disk'))),
    );
    const media = box(
      'mdia',
      box('hdlr', '\0\0\0\0mhlrvideSECRETSECRETSECRET'),
      box('minf', box('vmhd', 'how'), places, tables),
      box('SECR', 'SECRET'),
    );
    const film = joined(
      box('ftyp', 'qt  '),
      box('wide'),
      box('free', 'SECRET'),
      box('SECR', 'SECRET'),
      box('mdat', 'pictures'),
      box(
        'moov',
        box('mvhd', new Uint8Array(100)),
        box('trak', box('tkhd', new Uint8Array(84)), media),
        box('SECR', 'SECRET'),
        joined([0, 0, 0, 0]),
      ),
      box('sefd', 'SECRET'),
      box('free', 'SECRET'),
      'SECRET',
    );
    const { blob, text } = await stripped(new Blob([film], { type: 'video/quicktime' }));
    expect(blob.size).toBe(Buffer.from(film).indexOf(Buffer.from('sefd')) - 4);
    expect(
      ['pictures', 'vide', 'mhlr', 'avc1', 'avcChow', 'stcowhere', 'vmhdhow', 'SECR'].map((word) =>
        text.includes(word),
      ),
    ).toEqual([true, true, true, true, true, true, true, false]);
    const elsewhere = Buffer.from(film);
    elsewhere[elsewhere.indexOf('alis') + 7] = 0;
    expect((await withoutMetadata(new Blob([elsewhere]))).clean).toBe(false);
  });

  it('of a film whose track tells of the time of day is said to be in, and a film that is cut is left alone', async () => {
    const film = (kind: string) =>
      joined(
        box('ftyp', 'isom'),
        box('moov', box('trak', box('mdia', box('hdlr', `\0\0\0\0\0\0\0\0${kind}`)))),
        box('mdat', 'pictures'),
      );
    for (const kind of ['tmcd', 'text', 'meta', 'camm', 'SECR'])
      expect((await withoutMetadata(new Blob([film(kind)]))).clean, kind).toBe(false);
    for (const kind of ['vide', 'soun']) expect((await withoutMetadata(new Blob([film(kind)]))).clean, kind).toBe(true);
    for (const more of ['', 'SECRET', '\0\0\x10\0SECRET'])
      expect((await withoutMetadata(new Blob([film('vide'), more]))).blob.size).toBe(film('vide').length);
    for (const more of ['\0\0\x10\0mdatSECRET', '\0\0\x10\0moofSECRET'])
      expect((await withoutMetadata(new Blob([film('vide'), more]))).clean).toBe(false);
  });

  it('is said not to be out where it cannot be', async () => {
    for (const file of [
      new Blob(['what is this?']),
      new Blob([]),
      (await photo()).slice(0, 2000),
      new Blob([Uint8Array.of(0x1a, 0x45, 0xdf, 0xa3)]),
    ]) {
      const { blob, clean } = await withoutMetadata(file);
      expect([blob, clean]).toEqual([file, false]);
    }
  });

  it('survives bytes of any kind', async () => {
    const starts = [
      '\xff\xd8\xff',
      '\x89PNG\r\n\x1a\n',
      'RIFF\x20\0\0\0WEBP',
      'GIF89a',
      'BM',
      'II*\0\x08\0\0\0',
      'MM\0*\0\0\0\x08',
      '\0\0\0\x10ftypheic\0\0\0\0',
      '\0\0\0\x10ftypisom\0\0\0\0',
    ];
    await fc.assert(
      fc.asyncProperty(fc.constantFrom(...starts), fc.uint8Array({ maxLength: 300 }), async (start, tail) => {
        const file = new Blob([
          Uint8Array.from([...start].map((letter) => letter.charCodeAt(0))),
          tail as Uint8Array<ArrayBuffer>,
        ]);
        const { blob } = await withoutMetadata(file);
        expect(await bytesOf((await withoutMetadata(blob)).blob)).toEqual(await bytesOf(blob));
      }),
      { numRuns: 400 },
    );
  });
});

const ORACLES = new URL('../../../tests/oracles/data/', import.meta.url);
const files = async () =>
  (
    await Promise.all(
      ['files/', 'foreign/', 'animations/'].map(async (folder) =>
        (
          await readdir(new URL(folder, ORACLES))
        )
          .filter((name) => /\.(jpg|png|webp|gif|bmp|tif|avif)$/.test(name))
          .map((name) => folder + name),
      ),
    )
  ).flat();

describe('a photo that another program made', async () => {
  it.each(await files())('%s tells nothing any more, however much was put in', async (name) => {
    const plain = new Uint8Array(await readFile(new URL(name, ORACLES)));
    const { blob } = await stripped(new Blob([plain]));
    const loud = soiled(plain);
    expect(Buffer.from(loud).includes(Buffer.from('SECRET of the camera'))).toBe(true);
    const { blob: clean } = await stripped(new Blob([loud]));
    const text = await textOf(clean);
    for (const word of ['camera', '46.2', 'SECR', '2019:07:14', 'Tests']) expect(text).not.toContain(word);
    // Some files contain byte positions. Their pixels are compared in tests/web/wasm/metadata.spec.js.
    if (/\.(jpg|png|webp|gif)$/.test(name)) expect(await bytesOf(clean)).toEqual(await bytesOf(blob));
    else expect(clean.size).toBeLessThanOrEqual(loud.length - 'SECRET of the camera, Phone 99'.length);
  });
});

describe('a TIFF', () => {
  const tiff = async () => new Uint8Array(await readFile(new URL('files/tiff.tif', ORACLES)));

  it('whose words and pixels are the same bytes is said to tell', async () => {
    const file = soiled(await tiff());
    const view = new DataView(file.buffer);
    const at = view.getUint32(4, true);
    const fields = Array.from({ length: view.getUint16(at, true) }, (_, i) => at + 2 + 12 * i);
    const field = (tag: number) => fields.find((place) => view.getUint16(place, true) === tag) as number;
    // The metadata is between the pixels.
    view.setUint32(field(65000) + 8, view.getUint32(field(273) + 8, true), true);
    const { blob, clean } = await withoutMetadata(new Blob([file]));
    expect([clean, (await textOf(blob)).includes('SECRET')]).toEqual([false, false]);
    // A picture that overlaps its directory cannot be cleaned.
    view.setUint32(field(273) + 8, at, true);
    expect((await withoutMetadata(new Blob([file]))).blob.size).toBe(file.length);
  });

  it('is cleaned as quickly where it points to itself', async () => {
    const file = await tiff();
    const view = new DataView(file.buffer);
    const at = view.getUint32(4, true);
    view.setUint32(at + 2 + 12 * view.getUint16(at, true), at, true);
    expect((await withoutMetadata(new Blob([file]))).clean).toBe(false);
  });
});

describe('a BMP', () => {
  /** @param size of the head */
  function bmp(
    size: number,
    {
      bits = 8,
      packing = 0,
      told = 0,
      profile = '',
      tag = 'MBED',
    }: { bits?: number; packing?: number; told?: number; profile?: string; tag?: string },
    pixels: Uint8Array,
  ) {
    const colours = bits > 8 ? 0 : 4 * 2 ** bits;
    const start = 14 + size + colours + 6;
    const file = new Uint8Array(start + pixels.length + 6 + profile.length + 6).fill(0x53);
    const view = new DataView(file.buffer);
    file.set([0x42, 0x4d]);
    for (const [at, value] of [
      [2, file.length],
      [10, start],
      [14, size],
      [18, 3],
      [22, 2],
      [30, packing],
      [34, told],
      [38, 0],
      [42, 0],
      [46, 0],
      [50, 0],
    ])
      view.setUint32(at, value, true);
    view.setUint16(26, 1, true);
    view.setUint16(28, bits, true);
    file.set(pixels, start);
    if (size < 124) return file;
    for (let i = 0; i < 4; i += 1) file[70 + i] = tag.charCodeAt(3 - i);
    view.setUint32(14 + 112, start + pixels.length + 6 - 14, true);
    view.setUint32(14 + 116, profile.length, true);
    file.set(
      [...profile].map((letter) => letter.charCodeAt(0)),
      start + pixels.length + 6,
    );
    return file;
  }
  const runs = Uint8Array.of(3, 7, 0, 0, 0, 3, 1, 2, 3, 0, 0, 0, 0, 1);

  it.each([
    ['packed in runs', bmp(40, { packing: 1, told: 14 }, runs), runs],
    ['packed in runs of no told length', bmp(40, { packing: 1 }, runs), runs],
    ['of OS/2', bmp(64, { bits: 24 }, new Uint8Array(24)), new Uint8Array(24)],
    ['with a profile', bmp(124, { bits: 24, profile: 'PROFILE' }, new Uint8Array(24)), new Uint8Array(24)],
  ])('%s keeps its pixels and little else', async (name, file, pixels) => {
    const { blob, text } = await stripped(new Blob([file]));
    const bytes = await bytesOf(blob);
    const start = new DataView(bytes.buffer).getUint32(10, true);
    expect(bytes.subarray(start, start + pixels.length)).toEqual(pixels);
    expect(text.includes('PROFILE')).toBe(name === 'with a profile');
    expect(bytes.subarray(start - 6, start)).toEqual(new Uint8Array(6));
    expect(bytes.length).toBe(start + pixels.length + (name === 'with a profile' ? 13 : 0));
  });

  it('does not say the name of a profile that is elsewhere', async () => {
    const { blob, text } = await stripped(
      new Blob([bmp(124, { bits: 24, profile: 'C:\\Users\\Ada\\mine.icc', tag: 'LINK' }, new Uint8Array(24))]),
    );
    expect([text.includes('Ada'), text.includes('BGRs')]).toEqual([false, true]);
    expect(blob.size).toBe(14 + 124 + 6 + 24);
  });

  it.each([
    ['that is cut', bmp(40, { bits: 24 }, new Uint8Array(24)).subarray(0, 70)],
    ['that holds a JPEG', bmp(40, { bits: 24, packing: 4 }, new Uint8Array(24))],
    ['of a head that nobody knows', bmp(44, {}, new Uint8Array(8))],
  ])('%s is left alone, and said to be', async (_, file) => {
    const { blob, clean } = await withoutMetadata(new Blob([file]));
    expect([clean, await bytesOf(blob)]).toEqual([false, new Uint8Array(file)]);
  });
});
