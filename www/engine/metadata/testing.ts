/** Metadata as phones write it, for tests of its removal. */

/** Values that must not be in the result. The last two are 46 degrees and 12 minutes, in both byte orders. */
export const SECRETS = [
  'SECRET',
  'Phone 99',
  '2021:05:06',
  '\x2e\0\0\0\x01\0\0\0\x0c\0\0\0\x01',
  '\0\0\0\x2e\0\0\0\x01\0\0\0\x0c',
];

const ascii = (text: string) => [...text].map((letter) => letter.charCodeAt(0));

/**
 * A record of two directories: camera, date, orientation, place and EXIF, and then a thumbnail.
 * @param how `pixels`: with the fields of a TIFF image of 2 x 2 pixels
 */
export function record({
  orientation = 6,
  little = true,
  pixels = false,
}: {
  orientation?: number;
  little?: boolean;
  pixels?: boolean;
} = {}) {
  const bytes: number[] = [];
  const put = (at: number, value: number, size: number) => {
    for (let i = 0; i < size; i += 1) bytes[at + i] = (value >>> (8 * (little ? i : size - 1 - i))) & 0xff;
  };
  const SIZE = [0, 1, 1, 2, 4, 8, 1, 1];
  /** Writes a directory and what does not fit into it. */
  const directory = (at: number, fields: [tag: number, type: number, values: number[]][], next: number) => {
    put(at, fields.length, 2);
    let free = at + 2 + 12 * fields.length + 4;
    fields.forEach(([tag, type, values], i) => {
      const field = at + 2 + 12 * i;
      put(field, tag, 2);
      put(field + 2, type, 2);
      put(field + 4, type === 5 ? values.length / 2 : values.length, 4);
      const step = type === 5 ? 4 : SIZE[type];
      const length = step * values.length;
      put(field + 8, 0, 4);
      if (length > 4) put(field + 8, free, 4);
      values.forEach((value, j) => put((length > 4 ? free : field + 8) + j * step, value, step));
      if (length > 4) free += length + (length % 2);
    });
    put(at + 2 + 12 * fields.length, next, 4);
  };
  bytes.push(...(little ? [0x49, 0x49, 0x2a, 0] : [0x4d, 0x4d, 0, 0x2a]));
  put(4, 8, 4);
  const text = (value: string) => ascii(`${value}\0`);
  const picture: [number, number, number[]][] = pixels
    ? [
        [256, 3, [2]],
        [257, 3, [2]],
        [258, 3, [8]],
        [259, 3, [1]],
        [262, 3, [1]],
      ]
    : [];
  const strip: [number, number, number[]][] = pixels ? [[273, 4, [1200]]] : [];
  const rows: [number, number, number[]][] = pixels
    ? [
        [277, 3, [1]],
        [278, 3, [2]],
        [279, 4, [4]],
      ]
    : [];
  directory(
    8,
    [
      ...picture,
      [0x10e, 2, text('SECRET words')],
      [0x10f, 2, text('SECRET')],
      [0x110, 2, text('Phone 99')],
      ...strip,
      [0x112, 3, [orientation]],
      ...rows,
      [0x132, 2, text('2021:05:06 07:08:09')],
      [0x13b, 2, text('SECRET name')],
      [0x8769, 4, [500]],
      [0x8825, 4, [800]],
    ],
    pixels ? 0 : 1000,
  );
  directory(
    500,
    [
      [0x9003, 2, text('2021:05:06 07:08:09')],
      [0x927c, 7, ascii('SECRET note of the maker')],
      [0xa431, 2, text('SECRET number')],
    ],
    0,
  );
  directory(
    800,
    [
      [1, 2, text('N')],
      [2, 5, [46, 1, 12, 1, 3, 1]],
      [3, 2, text('E')],
      [0x1d, 2, text('2021:05:06')],
    ],
    0,
  );
  if (!pixels) {
    directory(
      1000,
      [
        [0x201, 4, [1100]],
        [0x202, 4, [16]],
      ],
      0,
    );
    ascii('SECRET thumbnail').forEach((value, i) => {
      bytes[1100 + i] = value;
    });
  }
  [11, 22, 33, 44].forEach((value, i) => {
    bytes[1200 + i] = value;
  });
  return Uint8Array.from({ length: 1204 }, (_, i) => bytes[i] ?? 0);
}

/** @returns a box of MP4 and HEIC */
export function box(type: string, ...content: (Uint8Array | string)[]): Uint8Array<ArrayBuffer> {
  const parts = content.map((part) => (typeof part === 'string' ? Uint8Array.from(ascii(part)) : part));
  const length = parts.reduce((sum, part) => sum + part.length, 8);
  const made = new Uint8Array(length);
  new DataView(made.buffer).setUint32(0, length);
  made.set(ascii(type), 4);
  let at = 8;
  for (const part of parts) {
    made.set(part, at);
    at += part.length;
  }
  return made;
}

/** @returns a segment of a JPEG */
export function segment(marker: number, ...content: (Uint8Array<ArrayBuffer> | string)[]): Blob {
  const body = new Blob(content);
  return new Blob([Uint8Array.of(0xff, marker, (body.size + 2) >> 8, (body.size + 2) & 0xff), body]);
}

/**
 * @param photo a JPEG
 * @returns the same photo with metadata as phones write it, and a video after its end
 */
export function loaded(photo: Blob): Blob {
  const said = [
    segment(0xe1, 'Exif\0\0', record()),
    segment(0xe1, 'http://ns.adobe.com/xap/1.0/\0<x:xmpmeta>SECRET</x:xmpmeta>'),
    segment(0xe2, 'MPF\0SECRET'),
    segment(0xed, 'Photoshop 3.0\0SECRET'),
    segment(0xfe, 'SECRET comment'),
  ];
  return new Blob([photo.slice(0, 2), ...said, photo.slice(2), box('moov', box('udta', 'SECRET place'))], {
    type: 'image/jpeg',
  });
}

/** Bytes of these parts. */
export function bytesOf(...parts: (Uint8Array | number[] | string)[]): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? ascii(part) : [...part])));
}

function number(value: number, size: number, little: boolean = false) {
  return Array.from({ length: size }, (_, i) => Math.floor(value / 256 ** (little ? i : size - 1 - i)) % 256);
}

const SECRET = 'SECRET of the camera, Phone 99';

/** A reference file with text wherever its format allows it and the image does not need it. */
export function soiled(file: Uint8Array): Uint8Array<ArrayBuffer> {
  const text = String.fromCharCode(...file.subarray(0, 12));
  if (text.startsWith('II*') || text.startsWith('MM\0*')) return soiledTiff(file);
  if (text.startsWith('BM')) return soiledBmp(file);
  if (text.startsWith('\xff\xd8')) return soiledJpeg(file);
  if (text.startsWith('\x89PNG')) return soiledPng(file);
  if (text.startsWith('RIFF')) return soiledWebp(file);
  if (text.startsWith('GIF8')) return soiledGif(file);
  if (text.slice(4, 8) === 'ftyp')
    return bytesOf(file, box('free', SECRET), box('uuid', SECRET), box('sefd', SECRET), SECRET);
  throw new Error('no such kind');
}

/** Unknown tags in a directory that is moved to the end. Text replaces the old directory. */
function soiledTiff(file: Uint8Array) {
  const little = file[0] === 0x49;
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const at = view.getUint32(4, little);
  const count = view.getUint16(at, little);
  const fields = Array.from({ length: count }, (_, i) => [...file.subarray(at + 2 + 12 * i, at + 14 + 12 * i)]);
  const secret = file.length + (file.length % 2);
  const small = secret + 64;
  const place = small + 64;
  const out = (tag: number, type: number, many: number, value: number[]) => [
    ...number(tag, 2, little),
    ...number(type, 2, little),
    ...number(many, 4, little),
    ...value,
  ];
  // Unknown types: in the field itself, a directory, and with a value after the end.
  const more = [
    ...[50839, 65000, 65105].map((tag) => out(tag, 2, SECRET.length, number(secret, 4, little))),
    out(65106, 77, SECRET.length, number(secret, 4, little)),
    out(65107, 2, 4, ascii('46.2')),
    out(65108, 13, 1, number(small, 4, little)),
    out(65109, 2, 99, number(0xfffffff0, 4, little)),
  ];
  const order = (field: number[]) => (little ? field[0] + 256 * field[1] : 256 * field[0] + field[1]);
  const all = [...fields, ...more].sort((one, other) => order(one) - order(other));
  const directory = [...number(all.length, 2, little), ...all.flat(), ...number(0, 4, little)];
  const body = bytesOf(
    file,
    new Uint8Array(secret - file.length),
    SECRET.padEnd(64),
    [...number(1, 2, little), ...out(271, 2, 4, ascii('SECR')), ...number(0, 4, little)],
    ''.padEnd(64 - 18, 'SECRET'),
    directory,
    SECRET,
  );
  body.set(ascii('SECRET'.repeat(count * 2 + 1)).slice(0, 6 + 12 * count), at);
  body.set(number(place, 4, little), 4);
  return body;
}

/** Adds data to reserved fields, to the gap before the pixels, to the ends of rows, and after the end. */
function soiledBmp(file: Uint8Array) {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const start = view.getUint32(10, true);
  const gap = ascii(SECRET.padEnd(64));
  const made = bytesOf(file.subarray(0, start), gap, file.subarray(start), SECRET);
  const to = new DataView(made.buffer);
  to.setUint32(2, made.length, true);
  to.setUint32(10, start + gap.length, true);
  made.set(ascii('SECR'), 6);
  const [used, row] = [
    Math.ceil((view.getInt32(18, true) * view.getUint16(28, true)) / 8),
    4 * Math.ceil((view.getInt32(18, true) * view.getUint16(28, true)) / 32),
  ];
  if (view.getUint32(30, true) === 0)
    for (let at = start + gap.length; at < made.length - SECRET.length; at += row)
      made.set(ascii('SEC').slice(0, row - used), at + used);
  return made;
}

/** A thumbnail, application segments and unknown segments, data between segments and after the end. */
function soiledJpeg(file: Uint8Array) {
  const part = (marker: number, ...content: (Uint8Array | number[] | string)[]) => {
    const body = bytesOf(...content);
    return bytesOf([0xff, marker], number(body.length + 2, 2), body);
  };
  const jfif = file[2] === 0xff && file[3] === 0xe0 ? 4 + 256 * file[4] + file[5] : 2;
  const first = jfif === 2 ? new Uint8Array(0) : part(0xe0, file.subarray(6, 18), [2, 2], SECRET.slice(0, 12));
  return bytesOf(
    file.subarray(0, 2),
    first,
    part(0xe0, 'JFXX\0\x10', SECRET),
    part(0xe4, SECRET),
    part(0xf5, SECRET),
    part(0x02, SECRET),
    part(0xc8, SECRET),
    SECRET,
    part(0xfe, SECRET),
    file.subarray(jfif),
    SECRET,
  );
}

function soiledPng(file: Uint8Array) {
  const part = (type: string, content: string) =>
    bytesOf(number(content.length, 4), type, content, number(crc32(bytesOf(type, content)), 4));
  const head = 33;
  return bytesOf(
    file.subarray(0, head),
    part('tEXt', `Author\0${SECRET}`),
    part('sPLT', `${SECRET}\0\x08`),
    part('prVt', SECRET),
    part('iTXt', `XML:com.adobe.xmp\0\0\0\0\0${SECRET}`),
    file.subarray(head),
    SECRET,
  );
}

function crc32(bytes: Uint8Array) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = crc & 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/** Unknown chunks, in animation frames as well, and data after the end. */
function soiledWebp(file: Uint8Array) {
  const part = (type: string, content: Uint8Array) =>
    bytesOf(type, number(content.length, 4, true), content, content.length % 2 ? [0] : []);
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const parts = [];
  for (let at = 12; at + 8 <= file.length; ) {
    const [type, length] = [String.fromCharCode(...file.subarray(at, at + 4)), view.getUint32(at + 4, true)];
    const content = file.subarray(at + 8, at + 8 + length);
    parts.push(part(type, type === 'ANMF' ? bytesOf(content, part('prVt', bytesOf(SECRET))) : content));
    at += 8 + length + (length % 2);
  }
  const body = bytesOf('WEBP', ...parts, part('prVt', bytesOf(SECRET)), part('XMP ', bytesOf(SECRET)));
  return bytesOf('RIFF', number(body.length, 4, true), body, SECRET);
}

/** Application extensions and unknown ones, oversized blocks, and data after the end. */
function soiledGif(file: Uint8Array) {
  const part = (label: number, ...blocks: string[]) =>
    bytesOf([0x21, label], ...blocks.map((block) => bytesOf([block.length], block)), [0]);
  const head = 13 + (file[10] & 0x80 ? 3 * 2 ** ((file[10] & 7) + 1) : 0);
  return bytesOf(
    file.subarray(0, head),
    part(0xfe, SECRET),
    part(0xff, 'XMP DataXMP', SECRET),
    part(0x01, '\0'.repeat(12), SECRET),
    part(0x77, SECRET),
    part(0xff, 'NETSCAPE2.0', SECRET),
    file.subarray(head),
    SECRET,
  );
}

/**
 * A HEIC file as phones write it: two images, camera metadata and text, in different places of the data.
 * @param how `version` of the item location box; `inside`: the metadata is in the list itself
 */
export function heic({
  version = 1,
  inside = false,
  orientation = 6,
}: {
  version?: number;
  inside?: boolean;
  orientation?: number;
} = {}) {
  const pixels = [0, 1].map((n) => Uint8Array.from({ length: 400 + n }, (_, i) => (i * 31 + n) % 251));
  const exif = bytesOf(number(6, 4), 'Exif\0\0', record({ orientation, little: false }));
  const words = bytesOf(`<?xpacket begin="x"?>${SECRET}<?xpacket end="w"?>`);
  const full = (type: string, of: number, ...content: (Uint8Array | number[] | string)[]) =>
    box(type, bytesOf([of, 0, 0, 0]), ...content.map((part) => bytesOf(part)));
  const info = (id: number, type: string, rest: string) => full('infe', 2, number(id, 2), [0, 0], type, rest);
  const infos = full(
    'iinf',
    0,
    number(4, 2),
    info(1, 'hvc1', `${SECRET}\0`),
    info(2, 'hvc1', '\0'),
    info(3, 'Exif', `${SECRET}\0`),
    info(4, 'mime', `${SECRET}\0application/rdf+xml\0`),
  );
  const properties = box(
    'iprp',
    box(
      'ipco',
      full('ispe', 0, number(64, 4), number(64, 4)),
      full('udes', 0, SECRET),
      full('crtt', 0, SECRET.slice(0, 8)),
      box('irot', bytesOf([1])),
    ),
    full('ipma', 0, number(1, 4), number(1, 2), [2, 0x81, 0x84]),
  );
  const head = box('ftyp', 'heic\0\0\0\0mif1heic');
  const wide = version === 2 ? 4 : 2;
  const ways = version > 0;
  /** offsets of the pieces */
  const metaAt = (data: number) => {
    const gap = SECRET.length;
    const second = data + gap + 400 + gap;
    const third = second + 401 + gap;
    const at = {
      1: [[data + gap, 400]],
      2: [[second, 401]],
      3: inside
        ? [[0, exif.length]]
        : [
            [third, 100],
            [third + 100, exif.length - 100],
          ],
      4: [[third + exif.length, words.length]],
    };
    const places = Object.entries(at).map(([id, extents]) =>
      bytesOf(
        number(Number(id), wide),
        ways ? number(inside && id === '3' ? 1 : 0, 2) : [],
        number(0, 2),
        number(extents.length, 2),
        ...extents.map(([from, length]) => bytesOf(number(from, 4), number(length, 4))),
      ),
    );
    const list = full('iloc', version, [0x44, 0], number(4, wide), ...places);
    return full(
      'meta',
      0,
      full('hdlr', 0, '\0\0\0\0pict\0\0\0\0\0\0\0\0\0\0\0\0', `${SECRET}\0`),
      full('pitm', 0, number(1, 2)),
      infos,
      list,
      properties,
      ...(inside ? [box('idat', exif, SECRET)] : []),
      box('uuid', SECRET),
    );
  };
  const before = bytesOf(head, metaAt(0), box('uuid', SECRET)).length + 8;
  const data = bytesOf(
    SECRET,
    pixels[0],
    SECRET,
    pixels[1],
    SECRET,
    inside ? new Uint8Array(exif.length) : exif,
    words,
    SECRET,
  );
  return {
    file: bytesOf(
      head,
      metaAt(before),
      box('uuid', SECRET),
      box('mdat', data),
      box('free', SECRET),
      box('mpvd', SECRET),
      SECRET,
    ),
    pixels,
  };
}
