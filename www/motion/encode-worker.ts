/**
 * Encodes the file of an animatic and ends: requests the images for the next frames, draws each frame, and passes it to
 * the browser's encoder through mediabunny, or to gifenc.
 */

import {
  AudioSample,
  AudioSampleSource,
  BufferTarget,
  canEncodeAudio,
  CanvasSource,
  Mp4OutputFormat,
  Output,
  WebMOutputFormat,
} from 'mediabunny';
import { applyPalette, GIFEncoder, quantize } from 'gifenc';
import { describe, failure } from '../engine/protocol.ts';
import { clipsOf, closeDrawn, drawFrame, frameAt, framesIn, same } from './frames.ts';
import { AUDIO_BITRATE, bitrateOf, CODECS, KINDS } from './kinds.ts';
import type { Drawn } from './frames.ts';
import type { Kind } from './kinds.ts';
import type { Sound } from './sound.ts';

type Begin = {
  kind: Kind;
  width: number;
  height: number;
  /** Frames per second. */
  rate: number;
  table: Float32Array;
  sound: Sound | null;
};
export type ToEncoder = Begin | (Drawn & { clip: number });
/** A request for the image of a clip, the number of encoded frames, the file, or an error. */
export type FromEncoder =
  | { wants: number }
  | { done: number }
  | { file: ArrayBuffer }
  | { error: { code: string; message: string } };

/** Seconds between key frames. Playback can start only at a key frame. */
const KEY_FRAMES = 2;
/** Frames between two progress reports. */
const TOLD = 6;

const pictures: Map<number, Drawn> = new Map();
/** Clips whose images were requested. */
const wanted: Set<number> = new Set();
let arrived: () => void = () => {};

globalThis.onmessage = async ({ data }: MessageEvent<ToEncoder>) => {
  if ('clip' in data) {
    pictures.set(data.clip, data);
    arrived();
    return;
  }
  try {
    const file = data.kind === 'gif' ? await gif(data) : await film(data);
    postMessage({ file } satisfies FromEncoder, { transfer: [file] });
  } catch (error) {
    postMessage({ error: describe(error) } satisfies FromEncoder);
  }
};

/** Draws all frames one after the other. @param use what becomes of the frame on the canvas */
async function eachFrame(
  { table, width, height }: Begin,
  use: (context: OffscreenCanvasRenderingContext2D, frame: number) => Promise<void> | void,
  { canvas = new OffscreenCanvas(width, height), reads = false }: { canvas?: OffscreenCanvas; reads?: boolean } = {},
) {
  const context = canvas.getContext('2d', { alpha: false, willReadFrequently: reads });
  if (!context) throw failure('animatic-encoder', 'The browser provides no canvas for the video.');
  const count = framesIn(table);
  const last = count > 0 ? clipsOf(frameAt(table, count - 1)).at(-1) : undefined;
  for (let frame = 0; frame < count; frame += 1) {
    // The picture on the canvas is reused while nothing moves.
    if (frame === 0 || !same(table, frame - 1, frame)) {
      const shown = frameAt(table, frame);
      const clips = clipsOf(shown);
      await have(clips, clips.at(-1) === last ? [] : [(clips.at(-1) ?? 0) + 1]);
      drawFrame(context, shown, { drawn: (clip) => pictures.get(clip), captionWidth: width });
    }
    await use(context, frame);
    if ((frame + 1) % TOLD === 0 || frame + 1 === count) postMessage({ done: frame + 1 } satisfies FromEncoder);
  }
}

/** Waits for the images of these clips, requests the images of the next clips, and frees all others. */
async function have(clips: number[], next: number[]) {
  const needed = [...clips, ...next];
  for (const [clip, drawn] of pictures) {
    if (needed.includes(clip)) continue;
    closeDrawn(drawn);
    pictures.delete(clip);
    wanted.delete(clip);
  }
  // The next images are drawn while these frames are encoded.
  for (const clip of needed) {
    if (wanted.has(clip)) continue;
    wanted.add(clip);
    postMessage({ wants: clip } satisfies FromEncoder);
  }
  while (!clips.every((clip) => pictures.has(clip)))
    await new Promise<void>((resolve) => {
      arrived = resolve;
    });
}

async function film(begin: Begin): Promise<ArrayBuffer> {
  const { kind, width, height, rate, table, sound } = begin;
  const { codec } = KINDS[kind];
  if (!codec) throw failure('animatic-encoder', `No film is a ${kind}.`);
  const target = new BufferTarget();
  const output = new Output({
    format: kind === 'mp4' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat(),
    target,
  });
  const canvas = new OffscreenCanvas(width, height);
  const source = new CanvasSource(canvas, {
    codec: codec.video,
    fullCodecString: CODECS[codec.video],
    bitrate: bitrateOf({ width, height }),
    keyFrameInterval: KEY_FRAMES,
  });
  output.addVideoTrack(source, { frameRate: rate });
  const voice = sound && (await voiceOf(sound, codec.audio));
  if (voice) output.addAudioTrack(voice);
  await output.start();
  try {
    if (voice && sound) await speak(voice, sound);
    await eachFrame(begin, (_, frame) => source.add(frame / rate, 1 / rate), { canvas });
    await output.finalize();
  } catch (error) {
    if (output.state !== 'finalized') await output.cancel().catch(() => {});
    throw (error as { code?: string }).code ? error : failure('animatic-encoder', (error as Error).message);
  }
  if (!target.buffer || framesIn(table) === 0) throw failure('animatic-encoder', 'The encoder gave nothing.');
  return target.buffer;
}

/** @throws `animatic-sound` if the browser has no encoder for this video format */
async function voiceOf({ channels, sampleRate }: Sound, codecs: readonly ('aac' | 'opus')[]) {
  for (const codec of codecs)
    if (await canEncodeAudio(codec, { numberOfChannels: channels.length, sampleRate, bitrate: AUDIO_BITRATE }))
      return new AudioSampleSource({ codec, bitrate: AUDIO_BITRATE });
  throw failure('animatic-sound', 'This browser cannot encode sound for this format.');
}

/** Hands a sound over second by second. */
async function speak(voice: AudioSampleSource, { channels, sampleRate }: Sound) {
  const [{ length }] = channels;
  for (let from = 0; from < length; from += sampleRate) {
    const count = Math.min(sampleRate, length - from);
    const data = new Float32Array(count * channels.length);
    channels.forEach((all, i) => data.set(all.subarray(from, from + count), i * count));
    const sample = new AudioSample({
      data,
      format: 'f32-planar',
      numberOfChannels: channels.length,
      sampleRate,
      timestamp: from / sampleRate,
    });
    await voice.add(sample);
    sample.close();
  }
}

/** Writes a GIF file. Identical frames become one longer frame. */
async function gif(begin: Begin): Promise<ArrayBuffer> {
  const { rate, table, width, height } = begin;
  const encoder = GIFEncoder();
  const count = framesIn(table);
  // Delays are hundredths of a second, so it is the ends that are rounded.
  const end = (frame: number) => Math.round((frame * 100) / rate) * 10;
  let first = 0;
  const add = (context: OffscreenCanvasRenderingContext2D, frame: number) => {
    const last = frame + 1 === count || !same(table, frame, frame + 1);
    if (!last) return;
    const { data } = context.getImageData(0, 0, width, height);
    const palette = quantize(data, 256, { format: 'rgb565' });
    const index = applyPalette(data, palette, 'rgb565');
    encoder.writeFrame(index, width, height, { palette, delay: end(frame + 1) - end(first), repeat: 0 });
    first = frame + 1;
  };
  await eachFrame(begin, add, { reads: true });
  encoder.finish();
  return encoder.bytes().slice().buffer;
}
