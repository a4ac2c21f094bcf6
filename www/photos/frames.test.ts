import { readFile } from 'node:fs/promises';
import { expect, test, vi } from 'vitest';
import { createStore } from '../document/store.ts';
import { createFrames } from './frames.ts';

const VIDEOS = new URL('../../tests/videos/', import.meta.url);

/** The properties of a video after its frames were read. */
async function readFilm(name: string) {
  const store = createStore();
  let next = 0;
  const intake = {
    freshIds: (count: number) => Array.from({ length: count }, () => `p${(next += 1)}`),
    isShown: () => false,
    arrived: () => {},
    count: () => {},
    failed: vi.fn(),
    leaveOut: (ids: string[]) => ids,
  };
  const importVideo = async (_file: File, { onAbout }: any) => onAbout({ duration: 3 });
  const frames = createFrames({ store, engine: { importVideo }, intake, messages: { alert: () => {} } } as any);
  const bytes = await readFile(new URL(name, VIDEOS));
  const { key } = frames.open(new File([new Uint8Array(bytes)], name), { frames: 2 });
  await frames.read(store.videos.value.get(key) as any, { signal: new AbortController().signal });
  expect(intake.failed).not.toHaveBeenCalled();
  return store.videos.value.get(key);
}

test('the timecode of a camera is stored with its film', async () => {
  expect(await readFilm('times/drop.mov')).toMatchObject({
    duration: 3,
    timecode: { frame: 1_080_710, fps: 30, drop: true },
  });
  expect(await readFilm('album.mp4')).not.toHaveProperty('timecode');
});
