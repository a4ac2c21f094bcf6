import { expect, test } from 'vitest';
import { decodeText, readText } from './text-file.ts';

const bytes = (...parts: (string | number[])[]) =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...Buffer.from(part, 'latin1')] : part)));
const utf16 = (text: string) => new Uint8Array(Buffer.from(text, 'utf16le'));
const swapped = (little: Uint8Array) => new Uint8Array(Buffer.from(little).swap16());

const TEXT = 'Öffnet die Tür – „leise“\r\n漢字\r\n';

test('UTF-8 and UTF-16 are read with and without a byte order mark, which is removed', () => {
  const unicode = { text: TEXT, guessed: false };
  const files = [
    new TextEncoder().encode(TEXT),
    new TextEncoder().encode(`\ufeff${TEXT}`),
    utf16(TEXT),
    utf16(`\ufeff${TEXT}`),
    swapped(utf16(TEXT)),
    swapped(utf16(`\ufeff${TEXT}`)),
  ];
  for (const file of files) expect(decodeText(file)).toEqual(unicode);
  expect(decodeText(new Uint8Array())).toEqual({ text: '', guessed: false });
});

// `'Öffnet die Tür – „leise“ €5…'.encode('cp1252')` in Python.
test('bytes that are not Unicode are read as Windows-1252, and that is a guess', () => {
  const file = bytes([0xd6], 'ffnet die T', [0xfc], 'r ', [0x96, 0x20, 0x84], 'leise', [0x93, 0x20, 0x80], '5', [0x85]);
  expect(decodeText(file)).toEqual({ text: 'Öffnet die Tür – „leise“ €5…', guessed: true });
});

test('bytes that are not text are refused', async () => {
  const files = [
    bytes([0x31, 0xe9, 0x0a, 0x01]),
    bytes('abcd', [0]),
    bytes([0xff, 0xfe, 0]),
    bytes([0xfe, 0xff, 0xd8, 0]),
    bytes([0x89], 'PNG\r\n', [0x1a, 0x0a, 0, 0, 0, 13]),
    bytes([0xff, 0xd8, 0xff, 0xe0, 0, 0x10], 'JFIF'),
    bytes('PK', [3, 4, 20, 0, 0, 0]),
  ];
  for (const file of files) expect(decodeText(file), [...file].join()).toBeNull();
  await expect(readText(new Blob([files[0]]))).rejects.toMatchObject({ code: 'not-text' });
});
