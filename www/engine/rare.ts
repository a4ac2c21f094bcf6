/**
 * Rare photo formats: WebP, TIFF, GIF, and colours of scanners or presses. Their decoders are in a separate module,
 * loaded with the first such photo.
 */

import { moduleBytes } from './module-bytes.ts';
import { onceMore } from './once-more.ts';
import type { Damage } from './types.ts';

const MODULE = new URL('../pkg-decoders/inkpanel_bg.wasm', import.meta.url);

type Decoders = typeof import('../pkg-decoders/inkpanel.js');

/** A photo as a file for the core; `taken` is the capture time, if any; `damage` describes the damage of a file. */
export type Converted = {
  file: Uint8Array<ArrayBuffer>;
  format: string;
  taken: string | null;
  damage: Damage | null;
};

/** Bytes of a WebP file from offset 8. */
const WEBP = [0x57, 0x45, 0x42, 0x50];

/**
 * @param bytes of a file
 * @returns by content; null for other formats
 */
export function rareKind(bytes: Uint8Array): 'GIF' | 'TIFF' | 'WebP' | null {
  const [a, b, c, d] = bytes;
  if (a === 0x47 && b === 0x49 && c === 0x46 && d === 0x38) return 'GIF';
  const riff = a === 0x52 && b === 0x49 && c === 0x46 && d === 0x46;
  if (riff && WEBP.every((byte, i) => bytes[8 + i] === byte)) return 'WebP';
  const intel = a === 0x49 && b === 0x49 && c === 0x2a && d === 0;
  const motorola = a === 0x4d && b === 0x4d && c === 0 && d === 0x2a;
  return intel || motorola ? 'TIFF' : null;
}

/** @throws with the codes of the core's decoders, and `decoders-missing` */
export async function converted(bytes: Uint8Array<ArrayBuffer>): Promise<Converted> {
  const photo = new (await decoders()).Converted(bytes);
  try {
    const { format, taken = null, missing, coarse } = photo;
    const damage = missing > 0 || coarse > 0 ? { missing, coarse } : null;
    return { file: photo.take() as Uint8Array<ArrayBuffer>, format, taken, damage };
  } finally {
    photo.free();
  }
}

/** @throws `decoders-missing` */
export const { get: decoders } = onceMore(load);

async function load(): Promise<Decoders> {
  const bytes = await moduleBytes(
    MODULE,
    'decoders-missing',
    'What reads such photos could not be loaded. Try again with a connection.',
  );
  const decoders = await import('../pkg-decoders/inkpanel.js');
  await decoders.default({ module_or_path: bytes });
  return decoders;
}
