import { expect, test } from 'vitest';
import { codecName, filmKind, isFilmStart } from './film-kinds.ts';

const bytes = (...parts: (string | number[])[]) =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...part].map((c) => c.charCodeAt(0)) : part)));

test('a film is told by what is in it, whatever its name', async () => {
  expect(isFilmStart(bytes([0, 0, 0, 24], 'ftypisom'))).toBe(true);
  expect(isFilmStart(bytes([0, 0, 0, 24], 'ftypheic'))).toBe(false);
  expect(isFilmStart(bytes([0, 0, 0, 24], 'ftypavif'))).toBe(false);
  expect(isFilmStart(bytes([0x1a, 0x45, 0xdf, 0xa3]))).toBe(true);
  expect(isFilmStart(bytes('RIFF', [1, 2, 3, 4], 'AVI LIST'))).toBe(true);
  expect(isFilmStart(bytes('RIFF', [1, 2, 3, 4], 'WEBPVP8 '))).toBe(false);
  expect(isFilmStart(bytes([0xff, 0xd8, 0xff]))).toBe(false);
  expect(isFilmStart(bytes())).toBe(false);
});

test('what cannot be read is called as people call it', async () => {
  const avi = bytes('RIFF', [0, 0, 0, 0], 'AVI LIST', [0, 0, 0, 0], 'hdrlavih', 'strh', [56, 0, 0, 0], 'vidsXVID');
  expect(await filmKind(new Blob([avi]))).toEqual({ container: 'AVI', codec: 'MPEG-4 Part 2' });
  const theora = bytes('OggS', [0, 2, 0, 0, 0, 0, 0, 0], [0x80], 'theora');
  expect((await filmKind(new Blob([theora]))).container).toBe('Theora');
  const mov = bytes([0, 0, 0, 20], 'ftypqt  ', 'stsd', [0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 90], 'apch');
  expect(await filmKind(new Blob([mov]))).toEqual({ container: null, codec: 'ProRes' });
  expect(await filmKind(new Blob([]))).toEqual({ container: null, codec: null });
  expect([codecName('hevc'), codecName('avc'), codecName('vp9')]).toEqual(['HEVC (H.265)', 'AVC', 'VP9']);
});
