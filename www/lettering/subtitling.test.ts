import { signal } from '@preact/signals';
import { expect, test, vi } from 'vitest';
import { createSubtitling, speechAmong } from './subtitling.ts';
import { readAssetsFromFiles } from '../engine/testing-assets.ts';
import { choosing } from '../ui/encodings.ts';
import type { ReadSubtitles, Spoken } from '../engine/speech.ts';

readAssetsFromFiles();

const NONE = { unplaced: 0, cues: 1, homeless: 0, left: 0, cut: 0, skipped: 0, flaws: [] };

/** @param told content of a file, by its text */
function app(told: (text: string) => ReadSubtitles, { film = true } = {}) {
  const [alert, note, fileFailed] = [vi.fn(), vi.fn(), vi.fn()];
  const change = vi.fn();
  const lay = vi.fn((words: readonly unknown[]) => {
    store.project.value = { ...store.project.value };
    return { shown: words.length, waiting: 0 };
  });
  const reword = vi.fn((texts: ReadonlyMap<string, string>) => texts.size);
  const frame = (id: string, time: number) => [id, { id, name: 'film.mp4', video: 'v', time }] as const;
  const page = { panels: [{ photo: 'f' }, { photo: 'f' }, { photo: 'x' }], merges: [[0, 1]] };
  const project = { page, pageId: 1, sheet: 4, others: [{ page, pageId: 2, sheet: 5 }], at: 1 };
  const subtitles = vi.fn((text: string) => told(text));
  const script = vi.fn((text: string) => {
    const words: Spoken[] = text ? [{ kind: 'balloon', text, auto: true, place: 3 }] : [];
    return { words, unplaced: 0, lines: words.length };
  });
  const store = {
    videos: signal(new Map(film ? [['v', { key: 'v', name: 'film.mp4' }]] : [])),
    album: signal(new Map(film ? [frame('f', 1.5), frame('g', 9), frame('h', 12)] : [])),
    verdicts: signal(new Map()),
    tray: signal([{ id: 'f' }, { id: 'g' }, { id: 'h', use: false }, { id: 'x' }]),
    sheets: signal([page]),
    project: signal(project),
    planner: signal(null),
    change,
  };
  const subtitling = createSubtitling({
    store,
    lettering: { lay, reword, step: () => 'step', ready: async () => ({}) },
    texts: async () => ({ subtitles, script }),
    messages: { alert, note, fileFailed },
  } as any);
  return { ...subtitling, subtitles, script, alert, note, lay, reword, fileFailed, change, store };
}

test('subtitles are told by their names, and a text is a script where somebody speaks in it', async () => {
  const wide = Buffer.from('\ufeffANNA: Hello', 'utf16le');
  const files = [
    new File(['1'], 'A.SRT'),
    new File([''], 'a.en.vtt'),
    new File(['Night.\nANNA: Hello'], 'script.txt'),
    new File([wide], 'wide.txt'),
    new File(['Dear diary, this is no photo.'], 'notes.txt'),
    new File(['ANNA: Hello'], 'srt.jpg'),
  ];
  expect((await speechAmong(files)).map(({ name }) => name)).toEqual(['A.SRT', 'a.en.vtt', 'script.txt', 'wide.txt']);
});

test('words go to frames in use, shown or not, and what was left out is told with the name of the file', async () => {
  const words: Spoken[] = [{ kind: 'balloon', text: 'x', frame: 1, cue: '9.000/0', auto: true }];
  const { open, subtitles, alert, lay } = app((text) =>
    text === 'many' ? { ...NONE, words, cues: 20_000, left: 1 } : { ...NONE, words, cut: 1 },
  );
  await open([new File(['many'], 'many.srt'), new File(['long'], 'long.vtt')]);
  const frames = [
    expect.objectContaining({ time: 1.5, shown: true }),
    expect.objectContaining({ time: 9, shown: false }),
  ];
  const taking = { kind: 'balloon', sounds: false };
  expect(subtitles.mock.calls).toEqual([
    [expect.anything(), false, frames, 4, taking],
    [expect.anything(), true, frames, 4, taking],
  ]);
  // The panel is the panel of the photo, on any page.
  const laid = { kind: 'balloon', text: 'x', auto: true, photo: 'g', panel: 0, cue: 'film.mp4 9.000/0' };
  expect(lay.mock.calls).toEqual([[[laid]], [[laid]]]);
  expect(alert.mock.calls).toEqual([
    [expect.stringMatching(/^many\.srt: 20,000 subtitles were read; 1 more/)],
    [expect.stringMatching(/^long\.vtt: a subtitle is too long/)],
  ]);
});

test('without a film they are laid over the panels of all pages, of merged ones the first', async () => {
  const words: Spoken[] = [0, 3].map((place) => ({ kind: 'balloon', text: 'x', place, auto: true }));
  const { open, lay } = app(() => ({ ...NONE, words }), { film: false });
  await open([new File(['x'], 'a.srt')]);
  const word = { kind: 'balloon', text: 'x', auto: true };
  expect(lay.mock.calls[0][0]).toEqual([
    { ...word, sheet: 5, panel: 0 },
    { ...word, sheet: 4, panel: 2 },
  ]);
});

test('a script is laid over panels, and one that says nothing is refused with a sentence', async () => {
  const { put, lay, alert, note } = app(() => ({ ...NONE, words: [] }));
  expect(await put('Hi')).toBe(true);
  expect(lay.mock.calls[0][0]).toEqual([{ kind: 'balloon', text: 'Hi', auto: true, sheet: 4, panel: 2 }]);
  expect(note).toHaveBeenCalledWith(expect.stringMatching(/^1 text item was added/));
  expect(await put('')).toBe(false);
  expect(alert).toHaveBeenCalledWith(expect.stringMatching(/it has no dialogue/));
});

test('text that no panel has room for is unplaced, and its number is reported', async () => {
  const place = (places: (number | undefined)[]) =>
    places.map(
      (place, i): Spoken => ({ kind: 'balloon', text: `${i}`, auto: true, ...(place !== undefined && { place }) }),
    );
  const words = place([0, 3, undefined, undefined]);
  const cases: [{ unplaced: number; waiting: number }, RegExp, 'note' | 'alert'][] = [
    [
      { unplaced: 2, waiting: 2 },
      /^2 of 4 lines were placed; 2 did not fit\. 2 are in the list of unplaced text\.$/,
      'note',
    ],
    [
      { unplaced: 9, waiting: 1 },
      /^2 of 11 lines were placed; 9 did not fit\. 1 is in .+ text\. 8 were left out\.$/,
      'alert',
    ],
  ];
  for (const [{ unplaced, waiting }, sentence, way] of cases) {
    const { open, lay, note, alert } = app(() => ({ ...NONE, words, unplaced }), { film: false });
    lay.mockReturnValue({ shown: 2, waiting });
    await open([new File(['x'], 'a.srt')]);
    const word = (text: string) => ({ kind: 'balloon', text, auto: true });
    expect(lay.mock.calls[0][0]).toEqual([
      { ...word('0'), sheet: 5, panel: 0 },
      { ...word('1'), sheet: 4, panel: 2 },
      word('2'),
      word('3'),
    ]);
    expect((way === 'note' ? note : alert).mock.calls).toEqual([[expect.stringMatching(sentence)]]);
    expect((way === 'note' ? alert : note).mock.calls).toEqual([]);
  }
});

test('what is wrong is said, with its line; single subtitles that are wrong are named', async () => {
  const words: Spoken[] = [{ kind: 'balloon', text: 'x', frame: 0, auto: true }];
  const { open, fileFailed, alert } = app((text) => {
    if (text === 'some') return { ...NONE, words, skipped: 1, flaws: [{ kind: 'order', line: 7 }] };
    return { flaw: text === 'time' ? { kind: 'time', line: 2, text: 'soon' } : { kind: 'header' } };
  });
  await open([new File(['time'], 'a.srt'), new File(['?'], 'b.vtt'), new File(['some'], 'c.srt')]);
  expect(fileFailed.mock.calls.map(([name, why]) => [name, why])).toEqual([
    ['a.srt', expect.stringMatching(/^line 2: “soon” is not a time/)],
    ['b.vtt', expect.stringMatching(/WEBVTT/)],
  ]);
  expect(alert).toHaveBeenCalledWith(expect.stringMatching(/^c\.srt: a subtitle was skipped: line 7/));
});

test('a file that is too large is refused before it is read', async () => {
  const { open, fileFailed } = app(() => ({ ...NONE, words: [] }));
  const arrayBuffer = vi.fn();
  await open([{ name: 'a.srt', size: 5_000_001, arrayBuffer } as any]);
  expect(arrayBuffer).not.toHaveBeenCalled();
  expect(fileFailed).toHaveBeenCalledOnce();
  expect(fileFailed).toHaveBeenCalledWith('a.srt', expect.stringMatching(/larger than 5 MB/), expect.anything());
});

test('subtitles in Windows-1252 are decoded like every other text file, and the guess is reported', async () => {
  const words: Spoken[] = [{ kind: 'balloon', text: 'x', frame: 0, auto: true }];
  const { open, subtitles, alert, fileFailed } = app(() => ({ ...NONE, words }));
  await open([
    new File([Uint8Array.of(0x43, 0x61, 0x66, 0xe9)], 'a.srt'),
    new File([Uint8Array.of(1, 2, 0xff)], 'b.srt'),
  ]);
  expect(subtitles.mock.calls.map(([text]) => text)).toEqual(['Café']);
  expect(alert).toHaveBeenCalledWith(expect.stringMatching(/^a\.srt: .*Windows-1252/), expect.anything());
  expect(fileFailed).toHaveBeenCalledWith('b.srt', expect.stringMatching(/not a text file/), expect.anything());
});

test('a text that cannot be read is no script, and does not stop the other files', async () => {
  const gone = Object.assign(new File([''], 'gone.txt'), {
    slice: () => ({ arrayBuffer: () => Promise.reject(Error()) }),
  });
  expect(await speechAmong([gone, new File(['ANNA: Hello'], 'script.txt')])).toHaveLength(1);
});

test('a guessed encoding can be changed: the import is undone and repeated', async () => {
  const words: Spoken[] = [{ kind: 'balloon', text: 'x', frame: 0, auto: true }];
  const { open, subtitles, alert, change } = app(() => ({ ...NONE, words }));
  const cyrillic = Uint8Array.from(Buffer.from('cff0e8e2e5f22c20ece8f02120cae0ea20e4e5ebe03f', 'hex'));
  await open([new File([cyrillic], 'a.srt')]);
  const [text, way] = alert.mock.calls[0];
  expect(text).toMatch(/^a\.srt: .*Windows-1251/);
  way.run();
  expect(choosing.value).toMatchObject({ encoding: 'windows-1251' });
  choosing.value?.again('KOI8-R');
  await vi.waitFor(() => expect(subtitles).toHaveBeenCalledTimes(2));
  expect(change.mock.calls).toEqual([[{ type: 'undo' }]]);
  expect(subtitles.mock.calls.map(([said]) => said)).toEqual([
    'Привет, мир! Как дела?',
    expect.stringMatching(/^оПХБЕР/),
  ]);
});

test('after another edit, the changed encoding replaces the texts of the import and undoes nothing', async () => {
  const words = (text: string): Spoken[] =>
    text.split('\n').map((line) => ({ kind: 'balloon', text: line, frame: 0, auto: true }));
  const { open, alert, note, lay, reword, change, store } = app((text) => ({ ...NONE, words: words(text) }));
  const cyrillic = (text: string) => {
    const letters = [...text].map((letter) => {
      const code = letter.charCodeAt(0);
      return code >= 0x410 ? code - 0x350 : code;
    });
    return new File([Uint8Array.from(letters)], 'a.srt');
  };
  await open([cyrillic('Привет, мир! Как дела?\nХорошо')]);
  store.project.value = { ...store.project.value };
  alert.mock.calls[0][1].run();
  choosing.value?.again('KOI8-R');
  await vi.waitFor(() => expect(reword).toHaveBeenCalledOnce());
  const [texts, gesture] = reword.mock.calls[0] as unknown as [Map<string, string>, string];
  expect([[...texts.keys()], gesture]).toEqual([['Привет, мир! Как дела?', 'Хорошо'], 'step']);
  expect([...texts.values()]).toEqual([expect.stringMatching(/^оПХБЕР/), expect.stringMatching(/^уНПНЬН/)]);
  expect([lay.mock.calls.length, change.mock.calls.length]).toEqual([1, 0]);
  await vi.waitFor(() => expect(note).toHaveBeenCalledWith('2 texts were replaced. Edited texts did not change.'));
});

test('if another encoding has other texts, those of the import are deleted and the others are added', async () => {
  const words = (text: string): Spoken[] =>
    (text.startsWith('оПХБЕР') ? ['one', 'two'] : ['zero']).map((line) => ({
      kind: 'balloon',
      text: line,
      frame: 0,
      auto: true,
    }));
  const { open, alert, lay, reword, store } = app((text) => ({ ...NONE, words: words(text) }));
  const cyrillic = Uint8Array.from(Buffer.from('cff0e8e2e5f22c20ece8f02120cae0ea20e4e5ebe03f', 'hex'));
  await open([new File([cyrillic], 'a.srt')]);
  store.project.value = { ...store.project.value };
  alert.mock.calls[0][1].run();
  choosing.value?.again('KOI8-R');
  await vi.waitFor(() => expect(lay).toHaveBeenCalledTimes(2));
  expect(reword.mock.calls).toEqual([[new Map([['zero', '']]), 'step']]);
  expect(lay.mock.calls[1]).toEqual([
    [expect.objectContaining({ text: 'one' }), expect.objectContaining({ text: 'two' })],
    'step',
  ]);
});
