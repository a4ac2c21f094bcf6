import { readFileSync } from 'node:fs';
import { afterEach, expect, test, vi } from 'vitest';
import { asBmp } from './foreign.ts';

afterEach(() => vi.unstubAllGlobals());

/** The first box of a HEIC file, without an image. */
const HEADER = Uint8Array.from(Buffer.from('\0\0\0\x18ftypheic\0\0\0\0mif1heic', 'latin1'));

test('a damaged HEIC file that the browser cannot decode is reported by its kind', async () => {
  vi.stubGlobal('ImageDecoder', { isTypeSupported: async () => false });
  vi.stubGlobal(
    'fetch',
    async () => new Response(readFileSync(new URL('../pkg-heic/inkpanel_bg.wasm', import.meta.url))),
  );
  await expect(asBmp('HEIC', HEADER)).rejects.toMatchObject({ code: 'damaged-photo', message: 'HEIC' });
});

test('a damaged AVIF file is reported by its kind', async () => {
  const ImageDecoder = class {
    static isTypeSupported = async () => true;
    decode = () => Promise.reject(new DOMException('no image', 'EncodingError'));
    close() {}
  };
  vi.stubGlobal('ImageDecoder', ImageDecoder);
  await expect(asBmp('AVIF', HEADER)).rejects.toMatchObject({ code: 'damaged-photo', message: 'AVIF' });
});
