/** File types of animatics, and the file types that this browser can encode. */

export type Kind = 'mp4' | 'webm' | 'gif';

type Codec = { video: 'avc' | 'vp9'; audio: readonly ('aac' | 'opus')[] };

export const KINDS: Record<Kind, { ending: string; type: string; codec?: Codec }> = {
  mp4: { ending: 'mp4', type: 'video/mp4', codec: { video: 'avc', audio: ['aac', 'opus'] } },
  webm: { ending: 'webm', type: 'video/webm', codec: { video: 'vp9', audio: ['opus'] } },
  gif: { ending: 'gif', type: 'image/gif' },
};

/**
 * Limits of a GIF file: the longer side in pixels, frames per second, and duration. Larger files are too big to share.
 */
export const GIF = { side: 640, fps: 12, mostSeconds: 60 } as const;

/** Bits per second for each pixel of a frame. Lines and flat areas are clean from this value on. */
const BITS_A_PIXEL = 3.6;
/**
 * Bytes per pixel of a frame in a GIF file. Flat areas need .25, dots and grain .7, so the estimate is off by two
 * thirds at most.
 */
const GIF_BYTES_A_PIXEL = 0.45;
export const AUDIO_BITRATE = 160_000;

/** @returns bits per second */
export function bitrateOf({ width, height }: { width: number; height: number }): number {
  return Math.round(width * height * BITS_A_PIXEL);
}

/** @returns the approximate file size in bytes */
export function bytesOf(
  kind: Kind,
  { width, height, seconds, sound }: { width: number; height: number; seconds: number; sound: boolean },
): number {
  if (kind === 'gif') return width * height * GIF.fps * seconds * GIF_BYTES_A_PIXEL;
  return ((bitrateOf({ width, height }) + (sound ? AUDIO_BITRATE : 0)) / 8) * seconds;
}

/** @returns the size of a GIF file of frames of that size, in even numbers of pixels */
export function gifSize({ width, height }: { width: number; height: number }): { width: number; height: number } {
  const factor = Math.min(1, GIF.side / Math.max(width, height));
  const even = (side: number) => 2 * Math.round((side * factor) / 2);
  return { width: even(width), height: even(height) };
}

/** The codec as WebCodecs calls it: H.264 high at a level that holds 1080p at 60 frames, VP9 of 8 bits. */
export const CODECS = { avc: 'avc1.64002a', vp9: 'vp09.00.41.08' } as const;

/**
 * Tests the encoder with a frame, because browsers may report unsupported formats.
 * @returns the kinds that it makes; GIF is made without it
 */
export async function kindsHere(size: { width: number; height: number }): Promise<Kind[]> {
  const kinds = Object.keys(KINDS) as Kind[];
  const made = await Promise.all(
    kinds.map(async (kind) => {
      const { codec } = KINDS[kind];
      return codec === undefined || (await encodes(CODECS[codec.video], size).catch(() => false));
    }),
  );
  return kinds.filter((_, i) => made[i]);
}

async function encodes(codec: string, { width, height }: { width: number; height: number }): Promise<boolean> {
  if (typeof VideoEncoder !== 'function') return false;
  let chunks = 0;
  let failed = false;
  const encoder = new VideoEncoder({
    output: () => {
      chunks += 1;
    },
    error: () => {
      failed = true;
    },
  });
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext('2d');
  const frame = new VideoFrame(canvas, { timestamp: 0 });
  try {
    encoder.configure({ codec, width, height, bitrate: bitrateOf({ width, height }) });
    encoder.encode(frame, { keyFrame: true });
    await encoder.flush();
    return chunks > 0 && !failed;
  } finally {
    frame.close();
    if (encoder.state !== 'closed') encoder.close();
  }
}
