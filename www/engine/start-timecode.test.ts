import fc from 'fast-check';
import { readFile } from 'node:fs/promises';
import { expect, test } from 'vitest';
import { startTimecode } from './start-timecode.ts';
import { box, bytesOf } from './metadata/testing.ts';

const VIDEOS = new URL('../../tests/videos/', import.meta.url);
const bytes = async (name: string) => new Uint8Array(await readFile(new URL(name, VIDEOS)));
const read = (...parts: BlobPart[]) => startTimecode(new Blob(parts));

/** A number of 4 bytes. */
const number = (value: number) => [24, 16, 8, 0].map((shift) => (value >>> shift) & 255);

/** The box of a movie with one timecode track, whose sample is at a place of the file. */
function movie({
  kind = 'tmcd',
  flags = 0,
  scale = 25,
  duration = 1,
  fps = 25,
  place = 8,
  long = false,
}: Partial<Record<'flags' | 'scale' | 'duration' | 'fps' | 'place', number>> & { kind?: string; long?: boolean } = {}) {
  const format = [...number(flags), ...number(scale), ...number(duration), fps, 0];
  const entry = box('tmcd', bytesOf([0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0], format));
  const offsets = long
    ? box('co64', bytesOf(number(0), number(1), number(0), number(place)))
    : box('stco', bytesOf(number(0), number(1), number(place)));
  const tables = box('stbl', box('stsd', bytesOf(number(0), number(1), entry)), offsets);
  const media = box('mdia', box('hdlr', bytesOf(number(0), 'mhlr', kind)), box('minf', tables));
  return box('moov', box('mvhd', 'head'), box('trak', box('tkhd', 'picture')), box('trak', media));
}

/** A sample of a track, before its movie. */
const sample = (frame: number) => box('mdat', bytesOf(number(frame)));

test('the timecode of a camera is that of the first picture of the film', async () => {
  // 10:00:59;20 and 23:59:58:12, see tests/videos/times/make.sh and ffprobe.
  expect(await read(await bytes('times/drop.mov'))).toEqual({ frame: 1_080_710, fps: 30, drop: true });
  expect(await read(await bytes('times/day.mp4'))).toEqual({ frame: 2_159_962, fps: 25, drop: false });
});

test('other films have none', async () => {
  for (const name of ['album.mp4', 'album.webm', 'turned.mov', 'times/late.ts', 'odd/headless.mp4'])
    expect(await read(await bytes(name)), name).toBe(null);
  expect(await read()).toBe(null);
});

test('a place beyond 4 gigabytes and a rate that is only told by durations are read', async () => {
  const start = { frame: 90_000, fps: 25, drop: false };
  expect(await read(sample(90_000), movie())).toEqual(start);
  expect(await read(sample(90_000), movie({ long: true }))).toEqual(start);
  expect(await read(sample(90_000), movie({ scale: 25_000, duration: 1000, fps: 0 }))).toEqual(start);
});

test('a timecode that is not one of a day is none', async () => {
  expect(await read(sample(25 * 86_400 - 1), movie())).not.toBe(null);
  expect(await read(sample(25 * 86_400), movie())).toBe(null);
  expect(await read(sample(2_589_407), movie({ fps: 30, flags: 1 }))).toEqual({
    frame: 2_589_407,
    fps: 30,
    drop: true,
  });
  expect(await read(sample(2_589_408), movie({ fps: 30, flags: 1 }))).toBe(null);
  // Drop-frame at 25, a counter, no rate at all, a rate that is too high, and a track of something else.
  for (const wrong of [{ flags: 1 }, { flags: 8 }, { fps: 0, scale: 0, duration: 0 }, { fps: 121 }, { kind: 'text' }])
    expect(await read(sample(0), movie(wrong)), JSON.stringify(wrong)).toBe(null);
  // A sample that is not there.
  expect(await read(sample(0), movie({ place: 1e6 }))).toBe(null);
});

test('broken files are read without an error', async () => {
  const film = await bytes('times/drop.mov');
  for (let end = 0; end < film.length; end += 97) await expect(read(film.slice(0, end))).resolves.toBeDefined();
  const change = fc.tuple(fc.nat(2000), fc.integer({ min: 0, max: 255 }));
  await fc.assert(
    fc.asyncProperty(fc.array(change, { minLength: 1, maxLength: 8 }), async (changes) => {
      const broken = film.slice();
      for (const [at, value] of changes) broken[at] = value;
      const start = await read(broken);
      expect(start === null || start.frame < start.fps * 86_400).toBe(true);
    }),
    { numRuns: 200 },
  );
});
