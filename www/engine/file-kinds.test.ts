import { describe, expect, test } from 'vitest';
import { endingsOf, hasRole, isSidecar, kindByName, otherKind } from './file-kinds.ts';
import { FILE_KINDS } from './file-table.ts';

const file = (name: string, start = '') =>
  new File([Uint8Array.from(start, (character) => character.charCodeAt(0))], name);

describe('the kind of a file', () => {
  test('is known for every ending of the table, in any case', () => {
    for (const kind of FILE_KINDS)
      for (const ending of kind.endings.split(' ')) expect(kindByName(`a.${ending.toUpperCase()}`)).toBe(kind);
    for (const name of ['jpg', 'a', 'a.', 'a.unheard']) expect(kindByName(name)).toBeUndefined();
    expect(endingsOf('photo')).toContain('.jfif');
    expect(hasRole('a.HIF', 'photo')).toBe(true);
  });

  test('by its content counts more than by its name', async () => {
    expect((await otherKind(file('book.cbz', 'Rar!\x1a\x07\x01\x00')))?.name).toBe('RAR');
    expect((await otherKind(file('book.cbr', 'PK\x03\x04')))?.role).toBe('archive');
    expect((await otherKind(file('photo.jpg', '%PDF-1.7')))?.remedy).toBe('pages');
    expect((await otherKind(file('script.fdx', '<?xml')))?.name).toBe('Final Draft');
    expect(await otherKind(file('photo.jpg', '\xff\xd8'))).toBeUndefined();
    expect(await otherKind(file('empty'))).toBeUndefined();
  });
});

test('files of systems and programs are sidecars', () => {
  const sidecars = ['._a.jpg', '.DS_Store', 'Thumbs.db', 'desktop.ini', 'a.AAE', 'a.xmp', 'a.JPG.json', 'Icon\r'];
  for (const name of [...sidecars, 'a.HEIC.supplemental-metadata.json']) expect(isSidecar(name)).toBe(true);
  for (const name of ['a.jpg', 'layout.json', 'jpg.json', 'notes.txt', 'Icon']) expect(isSidecar(name)).toBe(false);
  expect(isSidecar('a.jpg', ['trip', '__MACOSX'])).toBe(true);
  expect(isSidecar('a.jpg', ['.trash'])).toBe(true);
});
