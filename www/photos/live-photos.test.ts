import { expect, test } from 'vitest';
import { noteFolders } from './folders.ts';
import { splitLivePhotos } from './live-photos.ts';

const at = (path: string, size = 1) => {
  const folders = path.split('/');
  const file = new File(['x'], folders.pop() as string);
  Object.defineProperty(file, 'size', { value: size });
  return noteFolders(file, folders);
};
const names = (files: readonly File[]) => files.map(({ name }) => name);

test('a video with the name of a photo in its folder belongs to the photo', () => {
  const { videos, others } = splitLivePhotos([
    at('IMG_1.HEIC'),
    at('IMG_1.MOV'),
    at('img_2.jpg'),
    at('IMG_2.mp4'),
    at('clip.mov'),
    at('a/IMG_3.HEIC'),
    at('b/IMG_3.MOV'),
    at('IMG_4.JPG'),
    at('IMG_4.MOV', 2 ** 30),
    at('IMG_4.srt'),
  ]);
  expect(names(videos)).toEqual(['IMG_1.MOV', 'IMG_2.mp4']);
  expect(names(others)).toEqual([
    'IMG_1.HEIC',
    'img_2.jpg',
    'clip.mov',
    'IMG_3.HEIC',
    'IMG_3.MOV',
    'IMG_4.JPG',
    'IMG_4.MOV',
    'IMG_4.srt',
  ]);
});
