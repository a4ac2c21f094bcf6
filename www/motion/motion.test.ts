import { describe, expect, it, vi } from 'vitest';
import { ANIMATIC } from '../engine/bounds.ts';
import { createAnimatics, USUAL } from './animatics.ts';
import { clock } from './clock.ts';
import { clipsOf, drawFrame, frameAt, framesIn, same } from './frames.ts';
import { bytesOf, gifSize } from './kinds.ts';
import { fitted } from './sound.ts';

const row = (under: number, over = -1, share = 0, read: number[] = [0, -1, 0, 0]) => [
  ...[under, 0.1, 0.2, 0.5, 0.25],
  ...[over, 0, 0, 1, 1, share],
  ...read,
];

describe('the table of frames', () => {
  const table = new Float32Array([row(0), row(0), row(0, 1, 0.5), row(1)].flat());

  it('has a row a frame', () => {
    expect(row(0)).toHaveLength(ANIMATIC.columns);
    expect(framesIn(table)).toBe(4);
  });

  it('says which clips are seen, and how much of the one over the other', () => {
    expect(frameAt(table, 0).under).toEqual({
      clip: 0,
      view: { x: Math.fround(0.1), y: Math.fround(0.2), width: 0.5, height: 0.25 },
    });
    expect(frameAt(table, 0).over).toBeNull();
    expect(frameAt(table, 2).over).toEqual({ clip: 1, view: { x: 0, y: 0, width: 1, height: 1 }, share: 0.5 });
    expect([0, 2, 3].map((frame) => clipsOf(frameAt(table, frame)))).toEqual([[0], [0, 1], [1]]);
  });

  it('says how far a page is read, and which picture of a panel that moves is seen', () => {
    const read = new Float32Array(row(0, -1, 0, [2.5, 3, 0.5, 7]));
    expect(frameAt(read, 0)).toMatchObject({ words: 2.5, panel: 3, veil: 0.5, beat: 7 });
  });

  it('tells frames that are the same', () => {
    expect([0, 1, 2].map((frame) => same(table, frame, frame + 1))).toEqual([true, false, false]);
  });
});

describe('the file', () => {
  it('reports progress before the plan is made', () => {
    const engine = { motion: () => new Promise(() => {}) };
    const store = { sheets: { peek: () => [] } };
    const animatics = createAnimatics({ store, engine, boards: {} } as any);
    const onProgress = vi.fn();
    const wish = { ...USUAL, of: 'pages', living: false } as const;
    void animatics.film(wish, { signal: new AbortController().signal, onProgress });
    expect(onProgress.mock.calls).toEqual([[0, 1]]);
  });
});

describe('the files', () => {
  it('are smaller as GIF, in even pixels', () => {
    expect(gifSize({ width: 1920, height: 1080 })).toEqual({ width: 640, height: 360 });
    expect(gifSize({ width: 1080, height: 1920 })).toEqual({ width: 360, height: 640 });
    expect(gifSize({ width: 322, height: 180 })).toEqual({ width: 322, height: 180 });
  });

  it('grow with their length', () => {
    const film = { width: 1280, height: 720, seconds: 10, sound: false };
    expect(bytesOf('mp4', { ...film, seconds: 20 })).toBeCloseTo(2 * bytesOf('mp4', film));
    expect(bytesOf('mp4', { ...film, sound: true })).toBeGreaterThan(bytesOf('mp4', film));
  });

  it('tell their length in minutes and seconds', () => {
    expect([0, 9.99, 65, 3600].map(clock)).toEqual(['0:00', '0:09', '1:05', '60:00']);
  });
});

describe('a sound', () => {
  const sound = (length: number) => ({ channels: [new Float32Array(length).fill(1)], sampleRate: 100 });

  it('that is shorter than the film stays as it is', () => {
    expect(fitted(sound(50), 1).channels[0]).toEqual(new Float32Array(50).fill(1));
  });

  it('that is longer is cut, and fades to nothing', () => {
    const [cut] = fitted(sound(1000), 3).channels;
    expect(cut).toHaveLength(300);
    expect([cut[0], cut[149], cut[299]]).toEqual([1, 1, 0]);
    expect(cut[225]).toBeGreaterThan(0.4);
    expect(cut[225]).toBeLessThan(0.6);
  });
});

it('a picture near its size is drawn with the fast resampling, a reduced one with the good one', () => {
  const quality = (width: number, share: number) => {
    const used: string[] = [];
    const context: any = {
      canvas: { width: 100, height: 50 },
      drawImage: () => used.push(context.imageSmoothingQuality),
    };
    const shown = { clip: 0, view: { x: 0, y: 0, width: share, height: share } };
    const drawn: any = { picture: { width, height: width / 2 }, caption: null };
    const frame = { under: shown, over: null, words: 0, panel: -1, veil: 0, beat: 0 };
    drawFrame(context, frame, { drawn: () => drawn, captionWidth: 100 });
    return used[0];
  };
  expect([quality(120, 1), quality(240, 0.5), quality(200, 1)]).toEqual(['low', 'low', 'high']);
});
