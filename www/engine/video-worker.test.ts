import { beforeEach, expect, test, vi } from 'vitest';

/** A file whose frames are from 11.4 s to 23.4 s, one per second; requested times in seconds of the file. */
const FIRST = 11.4;
const asked = vi.hoisted(() => ({ times: [] as number[], stretch: {}, chosen: [] as unknown[] }));

vi.mock('mediabunny', () => {
  class Input {
    canRead = async () => true;
    getTracks = async () => [1];
    getPrimaryVideoTrack = async () => ({
      canDecode: async () => true,
      getFirstTimestamp: async () => FIRST,
      getDurationFromMetadata: async () => null,
      computeDuration: async () => FIRST + 12,
    });
    dispose() {}
  }
  class VideoSampleSink {
    async *samplesAtTimestamps(times: number[]) {
      for (const time of times) {
        asked.times.push(time);
        const timestamp = FIRST + Math.floor(time - FIRST);
        yield { timestamp, rotation: 0, squarePixelWidth: 1, squarePixelHeight: 1, toVideoFrame: () => {}, close() {} };
      }
    }
  }
  class EncodedPacketSink {
    getPacket = async () => ({ data: new Uint8Array(1) });
  }
  return { Input, VideoSampleSink, EncodedPacketSink, BlobSource: class {}, ALL_FORMATS: [] };
});
vi.mock('./frame-pixels.ts', () => ({ rgbaOf: async () => ({ width: 1, height: 1, data: new Uint8Array(4) }) }));
vi.mock('./film-looks.ts', () => ({
  createLooks: (_track: unknown, _looking: unknown, stretch: object) => {
    asked.stretch = stretch;
    return { isShort: async () => true, whole: async () => {} };
  },
}));
vi.mock('./film-module.ts', () => ({
  filmModule: async () => ({
    Looking: class {
      looks = 12;
      choose(end: number, count: number, taken: Float64Array, moments: Float64Array) {
        asked.chosen = [end, count, [...taken], [...moments]];
        return Float64Array.of(FIRST + 0.96, 1, FIRST + 8, 2);
      }
    },
  }),
}));

const messages: any[] = [];
const send = (data: object) => (globalThis as any).onmessage({ data });

/** The answer of the worker. */
async function answer(wish: object) {
  await import('./video-worker.ts');
  const file = new File([new Uint8Array(64)], 'film.ts');
  await send({ file, ...wish });
  const frames = messages.flatMap(({ frame }) => frame ?? []);
  const abouts = messages.flatMap(({ about }) => about ?? []);
  return { frames, abouts, error: messages.find(({ error }) => error)?.error, done: messages.at(-1)?.done };
}

const rounded = (times: readonly number[]) => times.map((time) => Math.round(time * 1000) / 1000);

beforeEach(() => {
  messages.length = 0;
  asked.times = [];
  vi.stubGlobal('VideoDecoder', class {});
  vi.stubGlobal('postMessage', (message: any) => {
    messages.push(message);
    // Each frame is processed before the next request.
    if (message.frame) send({ next: true });
  });
});

test('times of frames start at the first picture, wherever it is in the file', async () => {
  const { frames, abouts, error, done } = await answer({ count: 3 });
  expect([error, done]).toEqual([undefined, true]);
  expect(abouts[0].duration).toBeCloseTo(12, 9);
  expect(rounded(frames.map(({ time }) => time))).toEqual([2, 6, 10]);
  expect(rounded(asked.times)).toEqual([13.4, 17.4, 21.4]);
});

test('frames that were there before are at the same times again', async () => {
  const { frames } = await answer({ count: 2, times: [0, 0.96 + 4] });
  expect(rounded(frames.map(({ time }) => time))).toEqual([0, 4.96]);
  expect(rounded(asked.times)).toEqual([11.4, 16.36]);
});

test('a stretch, moments of subtitles and shots are told by that clock, too', async () => {
  const { frames, abouts } = await answer({ count: 0, shots: true, start: 0.5, end: 9, moments: [1, 8] });
  expect(asked.stretch).toEqual({ from: FIRST + 0.5, to: FIRST + 9 });
  expect(asked.chosen).toEqual([FIRST + 9, 0, [], [FIRST + 1, FIRST + 8]]);
  expect(rounded(frames.map(({ time }) => time))).toEqual([0.96, 8]);
  expect(frames.map(({ shot }) => shot)).toEqual([1, 2]);
  expect(abouts.every(({ duration }) => Math.abs(duration - 12) < 1e-9)).toBe(true);
});
