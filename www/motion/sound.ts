/** A custom soundtrack of an animatic: decoded by the browser, cut to the length of the video. */

import { failure } from '../engine/protocol.ts';

/** Samples between -1 and 1 of each channel, at most two. */
export type Sound = { channels: Float32Array<ArrayBuffer>[]; sampleRate: number };

const RATE = 48_000;
/** Duration of the fade-out in seconds, if the soundtrack is longer than the video. */
const FADE = 1.5;

/**
 * @param seconds duration of the video: longer sound is cut, with a fade
 * @throws `sound-unread`
 */
export async function soundOf(file: File, seconds: number): Promise<Sound> {
  let decoded: AudioBuffer;
  try {
    decoded = await new OfflineAudioContext(2, 1, RATE).decodeAudioData(await file.arrayBuffer());
  } catch {
    throw failure('sound-unread', 'The browser cannot decode the sound.', { photo: file.name });
  }
  const channels = Array.from({ length: Math.min(2, decoded.numberOfChannels) }, (_, i) => decoded.getChannelData(i));
  return fitted({ channels, sampleRate: decoded.sampleRate }, seconds);
}

/** @returns a copy, cut to a length with a fade */
export function fitted({ channels, sampleRate }: Sound, seconds: number): Sound {
  const length = Math.round(seconds * sampleRate);
  const fade = Math.min(length, Math.round(FADE * sampleRate));
  return {
    sampleRate,
    channels: channels.map((all) => {
      const cut = all.slice(0, length);
      if (all.length > length) for (let i = 0; i < fade; i += 1) cut[length - 1 - i] *= i / fade;
      return cut;
    }),
  };
}
