/**
 * Analyses the sound of one video and ends. Audio decoders exist only on the main thread, so there are two steps: check
 * for a sound track, then analyse the decoded sound.
 *
 * In: `{ file }`, then `{ samples, rate }`.
 * Out: `{ sound: { begins, length } | null }`, in seconds, then `{ events }`; or `{ error: { code, message } }`.
 */

import { ALL_FORMATS, BlobSource, Input } from 'mediabunny';
import { pictureEnds } from './animation-times.ts';
import { filmModule } from './film-module.ts';
import { describe, failure } from './protocol.ts';
import type { SoundEvent } from './types.ts';

export type SoundQuestion = { file: Blob } | { samples: Float32Array<ArrayBuffer>; rate: number };
export type SoundTrack = { begins: number; length: number };

globalThis.onmessage = async ({ data }: MessageEvent<SoundQuestion>) => {
  try {
    if ('file' in data) postMessage({ sound: await trackOf(data.file) });
    else postMessage({ events: await heard(data) });
  } catch (error) {
    postMessage({ error: describe(error) });
  }
};

async function trackOf(file: Blob): Promise<SoundTrack | null> {
  // A picture that moves has no sound.
  if ((await pictureEnds(file)).length > 0) return null;
  const input = new Input({ source: new BlobSource(file), formats: ALL_FORMATS });
  try {
    if (!(await input.canRead())) throw failure('video-format', 'It is not an MP4, MOV, WebM or Matroska video.');
    const track = await input.getPrimaryAudioTrack();
    if (!track) return null;
    // The times of a video start with its first frame.
    const pictures = await input.getPrimaryVideoTrack();
    const first = pictures ? Math.max(0, await pictures.getFirstTimestamp()) : 0;
    return { begins: Math.max(0, await track.getFirstTimestamp()) - first, length: await track.computeDuration() };
  } finally {
    input.dispose();
  }
}

async function heard({ samples, rate }: { samples: Float32Array; rate: number }): Promise<SoundEvent[]> {
  const { soundEvents } = await filmModule();
  return JSON.parse(soundEvents(samples, rate));
}
