/**
 * Photos that the core has no decoder for: HEIC and AVIF. The browser decodes them with WebCodecs, if it can. Reading pixels
 * back from a canvas is not reliable, because browsers that guard against fingerprinting alter them. HEIC photos that the
 * browser cannot decode are decoded by a separate module, see docs/design/heic.md.
 */

import { bmp } from './bmp.ts';
import { AVIF_BRANDS, HEIC_BRANDS } from './file-table.ts';
import { rgbaOf } from './frame-pixels.ts';
import { moduleBytes } from './module-bytes.ts';
import { onceMore } from './once-more.ts';
import { failure } from './protocol.ts';

const MODULE = new URL('../pkg-heic/inkpanel_bg.wasm', import.meta.url);

/**
 * @param bytes of a file
 * @returns by content; null for formats of the core
 */
export function foreignKind(bytes: Uint8Array): 'AVIF' | 'HEIC' | null {
  const text = (at: number) => String.fromCharCode(...bytes.subarray(at, at + 4));
  if (text(4) !== 'ftyp') return null;
  const brands = [text(8)];
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0);
  for (let at = 16; at + 4 <= Math.min(length, bytes.length, 256); at += 4) brands.push(text(at));
  if (brands.some((brand) => AVIF_BRANDS.includes(brand))) return 'AVIF';
  return brands.some((brand) => HEIC_BRANDS.includes(brand)) ? 'HEIC' : null;
}

/**
 * Converts the whole photo to a file that the core reads: a BMP file, upright, in sRGB and on white. So all limits apply to
 * such photos as well.
 */
export async function asBmp(kind: 'AVIF' | 'HEIC', bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  if (kind === 'HEIC' && !(await mayDecodeHeic())) return heicAsBmp(bytes);
  const frame = (await decoded(kind, bytes).catch((error) => {
    if (kind === 'AVIF' || error.code !== 'no-decoder') throw error;
    return null;
  })) as (VideoFrame & { rotation?: number; flip?: boolean }) | null;
  if (!frame) return heicAsBmp(bytes);
  const { rotation = 0, flip = false } = frame;
  return bmp({ ...(await rgbaOf(frame)), rotation, flip });
}

/** Safari decodes HEIC, and has no ImageDecoder. */
async function mayDecodeHeic(): Promise<boolean> {
  return typeof ImageDecoder === 'undefined' || ImageDecoder.isTypeSupported('image/heic');
}

/** @throws with the codes of the decoder, except `damaged-photo` for `damaged`, and `decoders-missing` */
async function heicAsBmp(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const photo = converted(await heic(), bytes);
  try {
    return photo.take() as Uint8Array<ArrayBuffer>;
  } finally {
    photo.free();
  }
}

function converted({ Converted }: Awaited<ReturnType<typeof heic>>, bytes: Uint8Array) {
  try {
    return new Converted(bytes);
  } catch (error) {
    throw (error as { code?: string }).code === 'damaged' ? damaged('HEIC') : error;
  }
}

const { get: heic } = onceMore(async () => {
  const module = await moduleBytes(
    MODULE,
    'decoders-missing',
    'The decoder of HEIC photos could not be loaded. Try again with a connection.',
  );
  const decoder = await import('../pkg-heic/inkpanel.js');
  await decoder.default({ module_or_path: module });
  return decoder;
});

/** The message of this code is only the kind of file, and the app says the sentence. */
const damaged = (kind: 'AVIF' | 'HEIC') => failure('damaged-photo', kind);

async function decoded(kind: 'AVIF' | 'HEIC', data: Uint8Array<ArrayBuffer>): Promise<VideoFrame> {
  const type = `image/${kind.toLowerCase()}`;
  if (typeof ImageDecoder !== 'undefined' && (await ImageDecoder.isTypeSupported(type))) {
    const decoder = new ImageDecoder({ type, data });
    try {
      return (await decoder.decode()).image;
    } catch {
      throw damaged(kind);
    } finally {
      decoder.close();
    }
  }
  try {
    const bitmap = await createImageBitmap(new Blob([data], { type }), { premultiplyAlpha: 'none' });
    const frame = new VideoFrame(bitmap, { timestamp: 0 });
    bitmap.close();
    return frame;
  } catch {
    throw failure(
      'no-decoder',
      `This browser cannot read this ${kind} photo. Save it as JPEG, or open this page in a browser that shows ${kind}.`,
    );
  }
}
