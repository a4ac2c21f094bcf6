import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { nextTask } from '../engine/scheduler.ts';
import { createSpeakers } from './speakers.ts';

function face(x: number, mouth: number) {
  return {
    ...{ label: 'face', score: 0.9, x, y: 0.1, width: 0.2, height: 0.3 },
    expression: { rightEye: 0.3, leftEye: 0.3, mouth, smile: 0 },
  };
}

/** @param cue of the only balloon, on a frame at 12 seconds */
async function watched({ cue = 'film.mp4 11.000/0', faces = [face(0.1, 0.1), face(0.6, 0.3)], ready = true } = {}) {
  const page = { panels: [{ photo: 'f' }], words: [{ kind: 'balloon', text: 'Hi', auto: true, photo: 'f', cue }] };
  const fact = { id: 'f', video: 'v', time: 12, meta: { subjects: [...faces, { label: 'dog' }] } };
  const film = { file: new File(['x'], 'film.mp4'), duration: 60 };
  const change = vi.fn();
  const album = signal(new Map([['f', fact]]));
  const store: any = {
    sheets: signal([page]),
    project: signal({ page, pageId: 1, sheet: 1, others: [], at: 0 }),
    album,
    videos: signal(new Map([['v', film]])),
    know: (fact: any) => {
      album.value = new Map(album.value).set(fact.id, fact);
    },
    change,
  };
  const moved = (faces: readonly any[]) =>
    faces.map((face, i) => ({ ...face, expression: { ...face.expression, mouth: i === 0 ? 0.4 : 0.05 } }));
  const watchLips = vi.fn(async (_: object, faces: readonly any[]) => moved(faces));
  const settled = (page: any) => ({ ...page, words: page.words.map((word: object) => ({ ...word, x: 0.2 })) });
  createSpeakers({ store, engine: { watchLips }, settled, ready: () => ready });
  await nextTask();
  await nextTask();
  const mouths = album
    .peek()
    .get('f')
    ?.meta.subjects.map((subject: any) => subject.expression?.mouth);
  return { watchLips, change, mouths };
}

test('the lips of a frame with two faces are compared once, and its balloon is placed again', async () => {
  const { watchLips, change, mouths } = await watched();
  expect(watchLips).toHaveBeenCalledTimes(1);
  expect(watchLips.mock.calls[0][0]).toMatchObject({ time: 12, duration: 60 });
  expect(mouths).toEqual([0.4, 0.05, undefined]);
  expect(change).toHaveBeenCalledTimes(1);
  expect(change.mock.calls[0][0]).toMatchObject({
    type: 'set-words',
    silent: true,
    pages: [{ at: 0, words: [{ x: 0.2 }] }],
  });
});

test('frames of one face, or far from the subtitle, are not compared, nor any before the page is at rest', async () => {
  for (const wish of [
    { faces: [face(0.1, 0.1)] },
    { cue: 'film.mp4 2.000/0' },
    { cue: 'film.mp4 13.000/0' },
    { ready: false },
  ])
    expect((await watched(wish)).watchLips).not.toHaveBeenCalled();
});
