/** Detects the format of a video by content, independent of the file name. */

import { AVIF_BRANDS, HEIC_BRANDS } from './file-table.ts';
import { isVideo } from './is-video.ts';

/** Containers that no reader supports, with their names. */
const FOREIGN: readonly [name: string, at: number, bytes: readonly number[]][] = [
  ['Flash Video', 0, [0x46, 0x4c, 0x56, 0x01]],
  ['Windows Media', 0, [0x30, 0x26, 0xb2, 0x75, 0x8e, 0x66, 0xcf, 0x11]],
  ['RealMedia', 0, [0x2e, 0x52, 0x4d, 0x46]],
  ['MPEG-PS', 0, [0x00, 0x00, 0x01, 0xba]],
  ['MPEG-2', 0, [0x00, 0x00, 0x01, 0xb3]],
];
/** Brands of photos in the boxes that videos have as well: HEIC, AVIF, JPEG XL and Canon raw. */
const PHOTO_BRANDS: readonly string[] = [...HEIC_BRANDS, ...AVIF_BRANDS, 'heif', 'jxl ', 'crx '];
/** Codec codes in AVI, MP4 and MOV files, and their display names. */
const CODECS: readonly [name: string, codes: RegExp][] = [
  ['HEVC (H.265)', /hvc1|hev1|hevc|dvh1|dvhe/i],
  ['ProRes', /prores|ap(?:cn|ch|cs|co|4h|4x)/i],
  ['MPEG-4 Part 2', /mp4v|xvid|divx|dx50|fmp4|mp4s/i],
  ['Motion JPEG', /mjp[ab2g]|jpeg/i],
  ['DV', /dv[cs5h]|dvsd|dvpp/i],
  ['Cinepak', /cvid/i],
  ['MPEG-2', /mx[35]|m2v1|mpg2|hdv\d/i],
  ['DNxHD', /avd[nh]/i],
  ['H.264', /avc1|avc3|h264|x264/i],
];
/** Number of bytes that are read at the beginning, and at the end, because some cameras write the index there. */
const ASKED = 64 << 10;
const ENDING = 1 << 20;

/** Properties of an unsupported video; `codec` is the display name. */
export type FilmKind = { container: string | null; codec: string | null };

export function isFilmStart(bytes: Uint8Array): boolean {
  const text = latin(bytes.subarray(0, 16));
  // HEIF photos are such boxes, too.
  if (/^....ftyp/s.test(text)) return !PHOTO_BRANDS.includes(text.slice(8, 12));
  if (/^....(?:moov|mdat|wide)/s.test(text)) return true;
  if (bytes[0] === 0x1a && bytes[1] === 0x45 && bytes[2] === 0xdf && bytes[3] === 0xa3) return true;
  // Packets of a transport stream are 188 bytes long.
  if ([0, 188, 376].every((at) => bytes[at] === 0x47)) return true;
  return containerOf(bytes) !== null;
}

/** Up to this number, every file is opened. Beyond it, files with an image type are skipped. */
const FEW = 24;

/**
 * @returns the videos among files, by content; also files that only have a video extension, so that they get an error
 *   message
 */
export async function filmsAmong(files: readonly (Blob & { name?: string })[]): Promise<Set<Blob>> {
  const asked = files.filter((file) => files.length <= FEW || !file.type.startsWith('image/'));
  const films = await Promise.all(
    asked.map(async (file) => {
      const start = new Uint8Array(
        await file
          .slice(0, 4096)
          .arrayBuffer()
          .catch(() => new ArrayBuffer(0)),
      );
      return isFilmStart(start) || (isVideo(file) && !isPhotoStart(start)) ? [file] : [];
    }),
  );
  return new Set(films.flat());
}

/** JPEG, PNG, GIF and WebP. */
function isPhotoStart(bytes: Uint8Array): boolean {
  return /^(?:\xff\xd8\xff|\x89PNG|GIF8|RIFF....WEBP)/s.test(latin(bytes.subarray(0, 12)));
}

/** @returns the format; nulls if it is unknown */
export async function filmKind(file: Blob): Promise<FilmKind> {
  const start = new Uint8Array(await file.slice(0, ASKED).arrayBuffer());
  const end = new Uint8Array(await file.slice(Math.max(0, file.size - ENDING)).arrayBuffer());
  const container = containerOf(start);
  return { container, codec: codecOf(start) ?? codecOf(end) };
}

/** @param codec name from the library or a file @returns the display name */
export function codecName(codec: string): string {
  return CODECS.find(([, codes]) => codes.test(codec))?.[0] ?? codec.toUpperCase();
}

function containerOf(bytes: Uint8Array): string | null {
  const text = latin(bytes.subarray(0, 16));
  if (/^RIFF....AVI /s.test(text)) return 'AVI';
  if (text.startsWith('OggS')) return latin(bytes.subarray(0, 4096)).includes('\x80theora') ? 'Theora' : null;
  return FOREIGN.find(([, at, wanted]) => wanted.every((byte, i) => bytes[at + i] === byte))?.[0] ?? null;
}

/** Codec in a sample description or a stream header. */
function codecOf(bytes: Uint8Array): string | null {
  const text = latin(bytes);
  const [, code] = /(?:stsd.{12}|vids)(\w{4})/s.exec(text) ?? [];
  return code === undefined ? null : (CODECS.find(([, codes]) => codes.test(code))?.[0] ?? null);
}

function latin(bytes: Uint8Array): string {
  let text = '';
  // The label latin1 means windows-1252, which has other characters at 0x80 to 0x9f.
  for (const byte of bytes) text += String.fromCharCode(byte);
  return text;
}
