import { expect, test } from 'vitest';
import { readAssetsFromFiles } from './testing-assets.ts';
import { decodeNames, decodeText, readText } from './text-file.ts';

readAssetsFromFiles();

const bytes = (...parts: (string | number[])[]) =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...Buffer.from(part, 'latin1')] : part)));
const utf16 = (text: string) => new Uint8Array(Buffer.from(text, 'utf16le'));
const swapped = (little: Uint8Array) => new Uint8Array(Buffer.from(little).swap16());

const TEXT = 'Öffnet die Tür – „leise“\r\n漢字\r\n';

test('UTF-8 and UTF-16 are read with and without a byte order mark, which is removed', async () => {
  const unicode = { text: TEXT, guessed: false, lost: 0 };
  const files = [
    new TextEncoder().encode(TEXT),
    new TextEncoder().encode(`\ufeff${TEXT}`),
    utf16(TEXT),
    utf16(`\ufeff${TEXT}`),
    swapped(utf16(TEXT)),
    swapped(utf16(`\ufeff${TEXT}`)),
  ];
  for (const file of files) expect(await decodeText(file)).toMatchObject(unicode);
  expect(await decodeText(new Uint8Array())).toEqual({ text: '', encoding: 'UTF-8', guessed: false, lost: 0 });
});

// `'Öffnet die Tür – „leise“ €5…'.encode('cp1252')` in Python.
test('bytes that are not Unicode are read as Windows-1252, and that is a guess', async () => {
  const file = bytes([0xd6], 'ffnet die T', [0xfc], 'r ', [0x96, 0x20, 0x84], 'leise', [0x93, 0x20, 0x80], '5', [0x85]);
  const western = { text: 'Öffnet die Tür – „leise“ €5…', encoding: 'windows-1252', lost: 0 };
  expect(await decodeText(file)).toEqual({ ...western, guessed: true });
  expect(await decodeText(file, 'windows-1252')).toEqual({ ...western, guessed: false });
  expect((await decodeText(file, 'windows-1251'))?.text).toContain('Цffnet die Tьr');
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
  for (const file of files) expect(await decodeText(file), [...file].join()).toBeNull();
  await expect(readText(new Blob([files[0]]))).rejects.toMatchObject({ code: 'not-text' });
});

// `'Привет, мир! Как дела?'.encode('cp1251')` and `'こんにちは、世界。'.encode('shift_jis')` in Python.
test('the encoding of other scripts is guessed', async () => {
  const cyrillic = Buffer.from('cff0e8e2e5f22c20ece8f02120cae0ea20e4e5ebe03f', 'hex');
  expect(await decodeText(cyrillic)).toMatchObject({
    text: 'Привет, мир! Как дела?',
    encoding: 'windows-1251',
    guessed: true,
  });
  const japanese = Buffer.from('82b182f182c982bf82cd814190a28a458142', 'hex');
  expect(await decodeText(japanese)).toMatchObject({
    text: 'こんにちは、世界。',
    encoding: 'Shift_JIS',
    guessed: true,
  });
});

test('names of an archive are decoded together', async () => {
  expect(await decodeNames([new TextEncoder().encode('あ.jpg'), bytes('b.jpg')])).toEqual(['あ.jpg', 'b.jpg']);
  // `'Köln/Straße.jpg'.encode('cp437')` in Python.
  const dos = [bytes('K', [0x94], 'ln/Stra', [0xe1], 'e.jpg'), bytes('caf', [0x82], '.jpg')];
  expect(await decodeNames(dos)).toEqual(['Köln/Straße.jpg', 'café.jpg']);
});
