/** ZIP files for tests: files of other programs, and malicious files. */

import { constants, crc32, deflateRawSync } from 'node:zlib';

/**
 * A file in the archive. Omitted fields are valid. `at`: its offset in the central directory. `local`: fields of its
 * local header that differ. `again`: it shares the bytes of another file.
 */
export type Made = {
  name: string;
  content?: Uint8Array;
  packed?: boolean;
  flags?: number;
  method?: number;
  crc?: number;
  length?: number;
  size?: number;
  at?: number;
  again?: boolean;
  extra?: Uint8Array;
  local?: {
    name?: string;
    flags?: number;
    method?: number;
    crc?: number;
    length?: number;
    size?: number;
    extra?: Uint8Array;
  };
};

/** @param end fields of the end record that differ */
export function zipOf(
  files: readonly Made[],
  end: { count?: number; total?: number; length?: number; start?: number; comment?: string } = {},
): Buffer<ArrayBuffer> {
  const parts: Buffer[] = [];
  const directory: Buffer[] = [];
  let at = 0;
  for (const {
    name,
    content = Buffer.alloc(0),
    packed = false,
    again = false,
    at: told,
    local = {},
    ...said
  } of files) {
    const raw = packed && said.size === undefined ? deflateRawSync(content) : Buffer.from(content);
    const whole = {
      name,
      flags: 0x0800,
      method: packed ? 8 : 0,
      crc: said.crc ?? crc32(content),
      length: raw.length,
      size: content.length,
      extra: Buffer.alloc(0),
      ...said,
    };
    const own = { ...whole, ...local };
    const head = Buffer.concat([
      fields([
        [4, 0x04034b50],
        [2, 20],
        [2, own.flags],
        [2, own.method],
        [4, 0x210000],
        [4, own.crc],
        [4, own.length],
        [4, own.size],
        [2, Buffer.byteLength(own.name)],
        [2, own.extra.length],
      ]),
      Buffer.from(own.name),
      own.extra,
    ]);
    directory.push(
      fields([
        [4, 0x02014b50],
        [2, 20],
        [2, 20],
        [2, whole.flags],
        [2, whole.method],
        [4, 0x210000],
        [4, whole.crc],
        [4, whole.length],
        [4, whole.size],
        [2, Buffer.byteLength(name)],
        [2, whole.extra.length],
        [2, 0],
        [2, 0],
        [2, 0],
        [4, 0],
        [4, told ?? at],
      ]),
      Buffer.from(name),
      Buffer.from(whole.extra),
    );
    if (again) continue;
    parts.push(head, raw);
    at += head.length + raw.length;
  }
  const list = Buffer.concat(directory);
  const { count = files.length, total = count, length = list.length, start = at, comment = '' } = end;
  const foot = fields([
    [4, 0x06054b50],
    [2, 0],
    [2, 0],
    [2, count],
    [2, total],
    [4, length],
    [4, start],
    [2, comment.length],
  ]);
  return Buffer.concat([...parts, list, foot, Buffer.from(comment)]);
}

function fields(list: [bytes: number, value: number][]) {
  const made = Buffer.alloc(list.reduce((sum, [bytes]) => sum + bytes, 0));
  let at = 0;
  for (const [bytes, value] of list) at = made.writeUIntLE(value, at, bytes);
  return made;
}

const PIECE = 16 * 2 ** 20;

/**
 * Zero bytes, deflated to a thousandth of their size.
 * @param megabytes a multiple of 16
 * @param begins the first bytes
 * @returns as DEFLATE without a head
 */
export function packedNothing(megabytes: number, begins: string = ''): Buffer<ArrayBuffer> {
  const piece = (bytes: Buffer) => deflateRawSync(bytes, { finishFlush: constants.Z_FULL_FLUSH });
  const nothing = piece(Buffer.alloc(PIECE));
  const first = Buffer.alloc(PIECE);
  first.write(begins, 'latin1');
  const pieces = Array.from({ length: (megabytes * 2 ** 20) / PIECE }, (_, i) => (i === 0 ? piece(first) : nothing));
  // A last block that is empty.
  return Buffer.concat([...pieces, Buffer.of(3, 0)]);
}
