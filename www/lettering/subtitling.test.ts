import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { createSubtitling, isSubtitles } from './subtitling.ts';
import type { ReadSubtitles } from '../engine/words.ts';

/** @param told what is read of a file, by its text */
function app(told: (text: string) => ReadSubtitles) {
  const [alert, note, fileFailed, addAll] = [vi.fn(), vi.fn(), vi.fn(), vi.fn(async () => 1)];
  const fact = { id: 'f', name: 'film.mp4', video: 'v', time: 1.5, meta: null, measures: null };
  const subtitles = vi.fn((bytes: Uint8Array) => told(new TextDecoder().decode(bytes)));
  const { open } = createSubtitling({
    store: {
      videos: signal(new Map()),
      album: signal(new Map([['f', fact]])),
      page: signal({ panels: [{ photo: 'f', crop: null }], merges: [] }),
    },
    lettering: { addAll, ready: async () => ({ subtitles }) },
    messages: { alert, note, fileFailed },
  } as any);
  return { open, subtitles, alert, addAll, fileFailed };
}

test('files are told by their names', () => {
  expect(['A.SRT', 'a.en.vtt', 'srt.jpg'].map((name) => isSubtitles({ name }))).toEqual([true, true, false]);
});

test('words go to the panels that show frames, and what was left out is told with the name of the file', async () => {
  const words = [{ kind: 'caption' as const, text: 'x', panel: 0, auto: true }];
  const { open, subtitles, alert, addAll } = app((text) =>
    text === 'many' ? { words, cues: 20_000, left: 1, cut: 0 } : { words, cues: 1, left: 0, cut: 1 },
  );
  await open([new File(['many'], 'many.srt'), new File(['long'], 'long.vtt')]);
  const frames = [expect.objectContaining({ panel: 0, time: 1.5 })];
  expect(subtitles.mock.calls).toEqual([
    [expect.anything(), false, frames, 'caption'],
    [expect.anything(), true, frames, 'caption'],
  ]);
  expect(addAll.mock.calls).toEqual([[words], [words]]);
  expect(alert.mock.calls).toEqual([
    [expect.stringMatching(/^many\.srt: 20000 subtitles were read; 1 more/)],
    [expect.stringMatching(/^long\.vtt: a subtitle is too long/)],
  ]);
});

test('what is wrong is said, with its line', async () => {
  const { open, fileFailed } = app((text) => ({
    flaw: text === 'time' ? { kind: 'time', line: 2, text: 'soon' } : { kind: 'header' },
  }));
  await open([new File(['time'], 'a.srt'), new File(['?'], 'b.vtt')]);
  expect(fileFailed.mock.calls).toEqual([
    ['a.srt', expect.stringMatching(/^line 2: “soon” is not a time/)],
    ['b.vtt', expect.stringMatching(/WEBVTT/)],
  ]);
});

test('a file that is too large is refused before it is read', async () => {
  const { open, fileFailed } = app(() => ({ words: [], cues: 0, left: 0, cut: 0 }));
  const arrayBuffer = vi.fn();
  await open([{ name: 'a.srt', size: 5_000_001, arrayBuffer } as any]);
  expect(arrayBuffer).not.toHaveBeenCalled();
  expect(fileFailed.mock.calls).toEqual([['a.srt', expect.stringMatching(/larger than 5 MB/)]]);
});
