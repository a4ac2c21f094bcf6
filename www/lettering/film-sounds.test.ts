import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { createFilmSounds } from './film-sounds.ts';
import type { SoundEvent } from '../engine/types.ts';

const VIDEO = { key: 'v', name: 'film.mp4', file: new File([''], 'film.mp4') } as any;

function sound(start: number, loudness = -10, more: Partial<SoundEvent> = {}): SoundEvent {
  return { start, end: start + 0.1, kind: 'hit', loudness, words: ['clap', 'crack', 'snap'], ...more };
}

/** Frames at 1, 4 and 9 seconds. The last one is on no page. */
function app(hearFilm = vi.fn(async (..._: any[]) => [] as SoundEvent[])) {
  const frame = (id: string, time: number) => [id, { id, video: 'v', time }] as const;
  const lay = vi.fn((words: readonly unknown[]) => ({ shown: words.length, waiting: 0 }));
  const note = vi.fn();
  const sheets = signal([{ panels: [{ photo: 'a' }, { photo: 'b' }, { photo: null }], words: [] as object[] }]);
  const sounds = createFilmSounds({
    store: {
      album: signal(new Map([frame('a', 1), frame('b', 4), frame('c', 9)])),
      sheets,
      project: signal({ waiting: [] }),
    },
    engine: { hearFilm },
    lettering: { lay, ready: async () => ({}) },
    messages: { note },
  } as any);
  return { ...sounds, sheets, lay, note, hearFilm };
}

test('a sound goes to the nearest frame on a page, the loudest three to each, and those near none are counted', () => {
  const { proposals } = app();
  const quiet = sound(1.2, -40);
  const music = sound(2.6, -30, { end: 12, kind: 'music', words: ['note', 'notes', 'tune'] });
  const { near, far } = proposals(VIDEO, [quiet, sound(0.4), sound(1.1), sound(1.3), sound(2.49), music, sound(9)]);
  expect(near.map(({ event, photo }) => [event.start, photo])).toEqual([
    [0.4, 'a'],
    [1.1, 'a'],
    [1.3, 'a'],
    [2.49, 'b'],
    [2.6, 'b'],
  ]);
  // The frame at 9 is on no page.
  expect(far).toBe(1);
});

test('what is taken is an effect of its photo, known by its film and its time', async () => {
  const { proposals, take, lay, note, sheets } = app();
  const [proposal] = proposals(VIDEO, [sound(1.5)]).near;
  expect(proposal.taken).toBeUndefined();
  await take(proposal, 'crack');
  const cue = 'film.mp4 sound 1.500';
  const effect = { kind: 'effect', text: 'CRACK!', photo: 'a', panel: 0, auto: true, cue, angle: -8 };
  expect(lay).toHaveBeenCalledWith([effect]);
  expect(note).toHaveBeenCalledWith('CRACK! was added to the page.');
  sheets.value = [{ ...sheets.value[0], words: [effect] }];
  expect(proposals(VIDEO, [sound(1.5)]).near[0].taken).toBe('CRACK!');
});

test('a note of music stands upright', async () => {
  const { proposals, take, lay } = app();
  const music = sound(0, -30, { end: 12, kind: 'music', words: ['note', 'notes', 'tune'] });
  await take(proposals(VIDEO, [music]).near[0], 'note');
  expect(lay).toHaveBeenCalledWith([expect.not.objectContaining({ angle: -8 })]);
  expect(lay).toHaveBeenCalledWith([expect.objectContaining({ text: '♪' })]);
});

test('a film is heard once at a time, says what is wrong in words, and can be stopped', async () => {
  const failing = app(vi.fn(() => Promise.reject(Object.assign(new Error('x'), { code: 'sound-none' }))));
  await failing.hear(VIDEO);
  expect(failing.of(VIDEO)).toEqual({ why: 'This video has no sound.' });
  const stopping = app(
    vi.fn(
      (_file: File, { signal: stop, onStage }: any) =>
        new Promise<SoundEvent[]>((_, reject) => {
          onStage('decoding');
          stop.addEventListener('abort', () => reject(Object.assign(new Error(''), { name: 'AbortError' })));
        }),
    ),
  );
  const heard = stopping.hear(VIDEO);
  await stopping.hear(VIDEO);
  expect(stopping.hearFilm).toHaveBeenCalledTimes(1);
  expect(stopping.of(VIDEO)).toEqual({ stage: 'decoding' });
  stopping.stop(VIDEO);
  await heard;
  expect(stopping.of(VIDEO)).toBeUndefined();
});
