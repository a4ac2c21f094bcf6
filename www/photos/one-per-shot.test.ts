import { expect, test } from 'vitest';
import { unreadMeta } from '../document/album.ts';
import { onePerShot } from './one-per-shot.ts';
import type { Fact } from '../document/album.ts';

const FACE = { label: 'face', score: 1, x: 0.4, y: 0.2, width: 0.2, height: 0.3 };

/** @param frames name, shot, sharpness, and whether it has a face */
function film(...frames: readonly [string, number | undefined, number, boolean?][]) {
  const photos = frames.map(([id, , sharpness, face]) => ({
    ...unreadMeta(id),
    sharpness,
    subjects: face ? [FACE] : [],
  }));
  const album = new Map(
    frames.map(([id, shot], i): [string, Fact] => [
      id,
      { id, name: id, meta: photos[i], measures: null, video: 'film', shot },
    ]),
  );
  const kept = (least: number) => onePerShot(photos, album, least).map(({ id }) => id);
  return { album, photos, kept };
}

test('each shot keeps its best frame: with a face, or sharper', () => {
  const { kept } = film(['a', 1, 5], ['b', 1, 9], ['c', 2, 9], ['d', 2, 1, true], ['e', 3, 1]);
  expect(kept(3)).toEqual(['b', 'd', 'e']);
});

test('with few shots, each shot keeps more frames, in their order', () => {
  const { kept } = film(['a', 1, 5], ['b', 1, 9], ['c', 1, 7], ['d', 2, 1]);
  expect(kept(3)).toEqual(['b', 'c', 'd']);
  expect(kept(4)).toEqual(['a', 'b', 'c', 'd']);
  expect(kept(9)).toEqual(['a', 'b', 'c', 'd']);
});

test('photos and frames of unknown shots stay', () => {
  const { photos, album } = film(['a', 1, 5], ['b', 1, 9], ['c', undefined, 1]);
  const photo = unreadMeta('photo');
  const kept = onePerShot([...photos, photo], album, 3).map(({ id }) => id);
  expect(kept).toEqual(['b', 'c', 'photo']);
});
