/**
 * Sounds of a video: the browser decodes them on the device, and a separate worker analyses them. The browser decodes
 * only complete files, so files that are too large or too long are skipped.
 */

import { createPool } from './pool.ts';
import { cancelled, failure } from './protocol.ts';
import { Priority } from './queue.ts';
import type { Hearing } from './protocol.ts';
import type { SoundEvent } from './types.ts';

/** Sample rate in samples per second. Frequencies above 8 kHz do not help to distinguish sounds. */
const RATE = 16_000;

/** Maximum size of a video in bytes, and of its sound in seconds. Both are completely in memory. */
export const MOST_SOUND = { bytes: 256e6, seconds: 20 * 60 };

/** The current step. */
export type SoundStage = 'decoding' | 'hearing';
/**
 * @returns the sounds, in the order of time
 * @throws `sound-none`, `sound-long`, `sound-large`, `sound-undecodable`, or an error of the video
 */
export async function hearFilm(
  file: Blob,
  { signal, onStage }: { signal: AbortSignal; onStage: (stage: SoundStage) => void },
): Promise<SoundEvent[]> {
  const pool = createPool<Hearing>({ size: 1, spawn });
  const call = { priority: Priority.PAGE, signal };
  try {
    onStage('decoding');
    const sound = await pool.run({ op: 'track', args: { file }, ...call });
    if (!sound) throw failure('sound-none', 'The video has no sound.');
    if (sound.length > MOST_SOUND.seconds) throw failure('sound-long', 'It is too long.');
    if (file.size > MOST_SOUND.bytes) throw failure('sound-large', 'It is too large.');
    const samples = await orStopped(decoded(file), signal);
    onStage('hearing');
    const args = { samples, rate: RATE };
    const events = await pool.run({ op: 'sounds', args, transfer: [samples.buffer], ...call });
    const at = (seconds: number) => Math.max(0, seconds + sound.begins);
    // A sound that ends before the first picture belongs to no frame.
    return events
      .map((event) => ({ ...event, start: at(event.start), end: at(event.end) }))
      .filter(({ end }) => end > 0);
  } finally {
    pool.dispose();
  }
}

/** @returns samples of one channel: the mean of all that there are */
async function decoded(file: Blob): Promise<Float32Array<ArrayBuffer>> {
  const bytes = await file.arrayBuffer();
  const context = new OfflineAudioContext(1, 1, RATE);
  const audio = await context.decodeAudioData(bytes).catch((error: Error) => {
    throw failure('sound-undecodable', error.message);
  });
  const samples = new Float32Array(audio.length);
  for (let channel = 0; channel < audio.numberOfChannels; channel += 1) {
    const part = audio.getChannelData(channel);
    for (let i = 0; i < samples.length; i += 1) samples[i] += part[i] / audio.numberOfChannels;
  }
  return samples;
}

function orStopped<Result>(work: Promise<Result>, signal: AbortSignal): Promise<Result> {
  return new Promise((resolve, reject) => {
    const stop = () => reject(cancelled());
    if (signal.aborted) stop();
    signal.addEventListener('abort', stop, { once: true });
    work.then(resolve, reject).finally(() => signal.removeEventListener('abort', stop));
  });
}

function spawn() {
  return new Worker(new URL('./sound-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-sound' });
}
