/**
 * Extracts frames of one video and ends. mediabunny finds the packets, and WebCodecs decodes them from the nearest key
 * frame. The file is read in pieces, and a frame is closed as soon as it is copied. So memory does not depend on the
 * length of the video. It is a separate worker, so that it can be stopped at any moment. The protocol is in
 * `frame-sender.ts`. Frames are taken at given times, or selected by the shots of the video.
 */

import { ALL_FORMATS, BlobSource, EncodedPacketSink, Input, VideoSampleSink } from 'mediabunny';
import { createFilmClock } from './film-clock.ts';
import { codecName, filmKind } from './film-kinds.ts';
import { createLooks } from './film-looks.ts';
import { filmModule } from './film-module.ts';
import { rgbaOf } from './frame-pixels.ts';
import { mayGoOn, sendFrame, serveFrames } from './frame-sender.ts';
import { describe, failure } from './protocol.ts';
import { runs, sampleTimes } from './sample-times.ts';
import type { FilmClock } from './film-clock.ts';
import type { FileWish } from './frame-sender.ts';
import type { InputVideoTrack, VideoSample } from 'mediabunny';

/** Frames of a long video before shot detection: for a first page, and some spare ones. */
const FIRST = 8;

/** Maximum automatic number of frames per video. */
const MOST = 120;
/** Frames by the clock, where shots cannot be found. */
const WITHOUT = 24;

type Place = { index: number; time: number; shot?: number };

serveFrames(read);

async function read(wish: FileWish) {
  if (typeof VideoDecoder === 'undefined') throw failure('video-decoder', 'This browser does not support WebCodecs.');
  const input = new Input({ source: new BlobSource(wish.file), formats: ALL_FORMATS });
  try {
    const track = await open(input, wish.file);
    const first = Math.max(0, await track.getFirstTimestamp());
    const { duration, reaches } = await lengthOf(track);
    if (!(reaches > 0 && reaches >= first)) throw failure('film-empty', 'The video has no frames.');
    const clock = createFilmClock(first);
    const whole = reaches < duration - 0.5 ? clock.inFilm(duration) : undefined;
    postMessage({ about: { duration: clock.inFilm(reaches), whole } });
    const sender = createSender(track, clock);
    const spread = { ...clock.wishInFile(wish), first, duration: reaches };
    try {
      if (wish.shots) await byShots(track, sender, spread, clock.inFilm(reaches));
      else await atTimes(sender, spread);
    } catch (error) {
      // If no frame could be decoded, the browser's own player may work.
      const { code, message } = describe(error);
      if (!sender.delivered()) throw code.startsWith('film-') ? error : failure('video-decoder', message);
      // Frames of a damaged video are still useful.
      if (!wish.shots) throw error;
    }
  } finally {
    input.dispose();
  }
}

type Sender = ReturnType<typeof createSender>;
/** In seconds of the file: when its first picture is shown, and when its last one ends. */
type Spread = Omit<FileWish, 'file'> & { first: number; duration: number };

async function atTimes(sender: Sender, { count, start, end, leading, times: told, first, duration }: Spread) {
  const times = told ? [...told] : sampleTimes({ first, duration, count, start, end });
  for (const run of runs(times.length, leading)) await sender.send(run.map((index) => ({ index, time: times[index] })));
}

/** @param duration of the video, as known to the app */
async function byShots(track: InputVideoTrack, sender: Sender, wish: Spread, duration: number) {
  const { count, start = 0, end = Infinity, first, moments = [] } = wish;
  const [from, to] = [Math.max(first, start), Math.min(wish.duration, end)];
  const films = await filmModule().catch(() => null);
  // A missing module must not prevent a page.
  if (!films) return atTimes(sender, { ...wish, count: count || WITHOUT });
  const looking = new films.Looking();
  const looks = createLooks(track, looking, { from, to });
  const asked = Float64Array.from(moments);
  const taken: number[] = [];
  let last = 0;
  const tell = (base: number, share: number) => (part: number) => {
    const now = base + share * part;
    if (now - last < 0.01) return;
    last = now;
    postMessage({ about: { duration, looked: Math.min(1, now) } });
  };
  const take = async (wanted: number) => {
    const chosen = placesOf(looking.choose(to, wanted, Float64Array.from(taken), asked));
    const fresh = freshOf(chosen, taken, wanted || MOST);
    const shotAt = new Map(chosen.map(({ time, shot }) => [time, shot]));
    const shots = taken.flatMap((time, index) => (shotAt.has(time) ? [[index, shotAt.get(time)]] : []));
    taken.push(...fresh.map(({ time }) => time));
    postMessage({ about: { duration, frames: wanted === FIRST ? undefined : taken.length, shots } });
    await sender.send(fresh);
  };
  if (await looks.isShort()) {
    await looks.whole(tell(0, 1));
  } else {
    await looks.glance();
    if (count === 0 || count > FIRST) await take(FIRST);
    const keys = await looks.keys(tell(0, 0.4));
    await looks.between(keys, tell(0.4, 0.6));
  }
  postMessage({ about: { duration, looked: 1 } });
  if (looking.looks === 0) throw failure('film-empty', 'The video has no frames.');
  await take(count);
  if (taken.length > 0) return undefined;
  // All of it is dark, or one colour: then that is what it shows.
  return atTimes(sender, { ...wish, count: Math.min(count || FIRST, FIRST), times: undefined });
}

/** @param chosen seconds and shots by turns */
function placesOf(chosen: Float64Array): Omit<Required<Place>, 'index'>[] {
  return Array.from({ length: chosen.length / 2 }, (_, i) => ({ time: chosen[2 * i], shot: chosen[2 * i + 1] }));
}

/** @param taken existing frames, which count. If there are too many, shots with a frame get no further one */
function freshOf(all: readonly Omit<Required<Place>, 'index'>[], taken: readonly number[], most: number): Place[] {
  const before = new Set(taken);
  const having = new Set(all.filter(({ time }) => before.has(time)).map(({ shot }) => shot));
  const fresh = all.filter(({ time }) => !before.has(time));
  let over = fresh.length + taken.length - most;
  const kept = fresh.filter(({ shot }) => {
    if (over <= 0 || !having.has(shot)) return true;
    over -= 1;
    return false;
  });
  return kept.slice(0, Math.max(0, most - taken.length)).map((place, i) => ({ ...place, index: taken.length + i }));
}

/** @returns `reaches`: readable duration in seconds, less than stated for a truncated file */
async function lengthOf(track: InputVideoTrack): Promise<{ duration: number; reaches: number }> {
  const packets = new EncodedPacketSink(track);
  const told = (await track.getDurationFromMetadata().catch(() => null)) ?? 0;
  const found = await track.computeDuration();
  // The stated duration of WebM and Matroska files may be wrong, so use the readable part.
  if (found > 0 && found < told - 0.5) return { duration: told, reaches: found };
  const duration = found;
  const whole = async (time: number) => {
    try {
      const packet = await packets.getPacket(time);
      return packet && packet.data.byteLength > 0 ? packet : null;
    } catch {
      return null;
    }
  };
  if (await whole(duration)) return { duration, reaches: duration };
  let [good, bad] = [0, duration];
  while (bad - good > 0.04) {
    const middle = (good + bad) / 2;
    if (await whole(middle)) good = middle;
    else bad = middle;
  }
  return { duration, reaches: good };
}

async function open(input: Input, file: Blob) {
  if (file.size === 0) throw failure('film-empty', 'The file is empty.');
  const { container, codec } = await filmKind(file);
  if (container !== null) throw failure('film-container', codec === null ? container : `${container}, ${codec}`);
  if (!(await input.canRead())) throw failure('video-format', 'It is not an MP4, MOV, WebM or Matroska video.');
  const track = await trackOf(input);
  if (!track) throw failure('video-empty', 'The video has only sound, no picture.');
  if (!(await track.canDecode())) {
    const told = track.codec === null ? (codec ?? '?') : codecName(track.codec);
    throw failure(told === 'H.264' ? 'video-decoder' : 'film-codec', told);
  }
  return track;
}

/** A file without an index, which is truncated. */
async function trackOf(input: Input) {
  const tracks = await input.getTracks().catch(() => []);
  if (tracks.length === 0) throw failure('film-cut', 'The file is incomplete: its index is missing.');
  return input.getPrimaryVideoTrack();
}

/** @param clock converts seconds of the file to seconds from the first picture, which the page uses */
function createSender(track: InputVideoTrack, clock: FilmClock) {
  const sink = new VideoSampleSink(track);
  // A video with few frames may return one frame for two times.
  const sent = new Set<number>();
  return { send, delivered: () => sent.size > 0 };

  async function send(wanted: readonly Place[]) {
    const places = [...wanted].sort((a, b) => a.time - b.time);
    let next = 0;
    for await (const sample of sink.samplesAtTimestamps(places.map(({ time }) => time + 1e-4))) {
      const place = places[next];
      next += 1;
      if (!sample || sent.has(sample.timestamp)) {
        sample?.close();
        continue;
      }
      sent.add(sample.timestamp);
      await mayGoOn();
      await handOver(sample, { ...place, time: clock.inFilm(place.time) });
    }
  }
}

async function handOver(sample: VideoSample, place: Place) {
  try {
    const { width, height, data } = await rgbaOf(sample.toVideoFrame());
    const { rotation, squarePixelWidth: squareWidth, squarePixelHeight: squareHeight } = sample;
    sendFrame({ ...place, width, height, squareWidth, squareHeight, rotation, data });
  } finally {
    sample.close();
  }
}
