/**
 * Analyses the sound of one video. Audio decoders exist only on the main thread, so there are two jobs: find the sound
 * track, then analyse the decoded sound.
 */

import { ALL_FORMATS, BlobSource, Input } from 'mediabunny';
import { pictureEnds } from './animation-times.ts';
import { filmModule } from './film-module.ts';
import { failure } from './protocol.ts';
import { serveJobs } from './serving.ts';
import type { Work } from './serving.ts';
import type { Hearing, SoundTrack } from './protocol.ts';

const OPERATIONS: Work<Hearing> = {
  track: async ({ file }) => ({ ok: await trackOf(file) }),
  sounds: async (args) => ({ ok: await heard(args) }),
};

serveJobs<Hearing>((op, args, slow) => OPERATIONS[op](args, slow));

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

async function heard({ samples, rate }: Hearing['sounds']['args']): Promise<Hearing['sounds']['ok']> {
  const { soundEvents } = await filmModule();
  return JSON.parse(soundEvents(samples, rate));
}
