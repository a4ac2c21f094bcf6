import { signal } from '@preact/signals';
import fc from 'fast-check';
import { describe, expect, test, vi } from 'vitest';
import { MOST_CUES, MOST_LETTERS, cueAt, isSubtitles, parseSubtitles, readSubtitles } from './subtitles.ts';
import { createSubtitling, matched } from './subtitling.ts';

const SRT =
  '\uFEFF1\r\n00:00:01,000 --> 00:00:02,500\r\n<i>Hello</i>\r\nthere\r\n\r\n2\r\n00:01:00,5 --> 01:00:01,250\r\n{\\an8}Bye\r\n';

describe('subtitles', () => {
  test('SubRip is read, without its marks', () => {
    expect(parseSubtitles(SRT, false).cues).toEqual([
      { start: 1, end: 2.5, text: 'Hello there' },
      { start: 60.5, end: 3601.25, text: 'Bye' },
    ]);
  });

  test('WebVTT is read, its notes, names and settings passed over', () => {
    const vtt =
      'WEBVTT Kind: captions\nLanguage: en\n\nNOTE a --> remark\n\nSTYLE\n::cue { color: red }\n\nintro\n00:04.000 --> 00:05.000 align:start\n<v Anna>Tom &amp; Jerry</v>\n\n01:00:00.000 --> 01:00:01.000\n\n\n00:01.000 --> 00:02.000\nFirst';
    expect(parseSubtitles(vtt, true).cues).toEqual([
      { start: 1, end: 2, text: 'First' },
      { start: 4, end: 5, text: 'Tom & Jerry' },
    ]);
  });

  test.each([
    ['', false, /no subtitles/],
    ['1\n00:00:01,000 > 00:00:02,000\nHi', false, /line 1: a time was expected/],
    ['1\n00:00:01 --> 00:00:02\nHi', false, /line 2: .* is not a time/],
    ['1\n00:99:01,000 --> 00:00:02,000\nHi', false, /line 2/],
    ['1\n00:00:01,000 --> 99999:00:02,000\nHi', false, /line 2: .* is not a time/],
    ['1\n00:00:03,000 --> 00:00:02,000\nHi', false, /ends before it starts/],
    ['1\n00:00:01,000 --> 00:00:02,000\nHi\n\nno time here\nnone', false, /line 5/],
    ['1\n', false, /line 1/],
    ['00:01.000 --> 00:02.000\nHi', true, /WEBVTT/],
    ['WEBVTT', true, /no subtitles/],
  ])('%j is an error with its reason', (text, vtt, reason) => {
    expect(() => parseSubtitles(text, vtt)).toThrow(reason);
  });

  test('files are told by their names, read in UTF-8 and UTF-16, and refused in anything else', async () => {
    expect([
      isSubtitles({ name: 'A.SRT' }),
      isSubtitles({ name: 'a.en.vtt' }),
      isSubtitles({ name: 'srt.jpg' }),
    ]).toEqual([true, true, false]);
    const wide = new Uint8Array(2 + 2 * SRT.length);
    new DataView(wide.buffer).setUint16(0, 0xfffe);
    [...SRT].forEach((letter, i) => new DataView(wide.buffer).setUint16(2 + 2 * i, letter.charCodeAt(0), true));
    expect((await readSubtitles(new File([wide], 'a.srt'))).cues).toHaveLength(2);
    await expect(readSubtitles(new File([new Uint8Array([0x31, 0xe9, 0x0a])], 'a.srt'))).rejects.toMatchObject({
      code: 'invalid-subtitles',
    });
    await expect(readSubtitles(new File(['1\0'], 'a.srt'))).rejects.toThrow(/not text/);
  });

  test('a frame has what is said at its time, or close to it', () => {
    const { cues } = parseSubtitles(SRT, false);
    expect(cueAt(cues, 2, 0.5)?.text).toBe('Hello there');
    expect(cueAt(cues, 2.9, 0.5)?.text).toBe('Hello there');
    expect(cueAt(cues, 5, 0.5)).toBeNull();
    expect(cueAt([], 5, 0.5)).toBeNull();
  });

  test('a subtitle goes to one frame only, the one nearest to its middle', () => {
    const frames = [
      { panel: 0, time: 1.1 },
      { panel: 1, time: 1.7 },
      { panel: 2, time: 30 },
      { panel: 3, time: 61 },
    ];
    expect(matched(parseSubtitles(SRT, false).cues, frames, 'caption')).toEqual([
      { kind: 'caption', text: 'Hello there', panel: 1, auto: true },
      { kind: 'caption', text: 'Bye', panel: 3, auto: true },
    ]);
  });
});

describe('files made to hang the page', () => {
  const CUE = '00:00:01,000 --> 00:00:02,000\n';
  /** Each of these is read again from every place where it stands by a careless reader. */
  const WALLS: Record<string, (length: number) => string> = {
    'of tags that do not end': (length) => `${CUE}${'<'.repeat(length)}`,
    'of places that do not end': (length) => `${CUE}${'{\\'.repeat(length / 2)}`,
    'of tags in tags': (length) => `${CUE}${'<'.repeat(length / 2)}${'>'.repeat(length / 2)}`,
    'of blocks': (length) => '0:0.0-->0:1.0\nx\n\n'.repeat(length / 17),
    'of empty lines': (length) => `${CUE}x\n${'\n'.repeat(length)}`,
    'of white space': (length) => `${CUE}x${' \t'.repeat(length / 2)}x`,
    'of entities that do not end': (length) => `${CUE}${'&a'.repeat(length / 2)}`,
    'of digits': (length) => `${'9'.repeat(length)}:00:00,000 --> 00:00:02,000\nx`,
    'of arrows': (length) => `${'-->'.repeat(length / 3)}\nx`,
  };

  test.each(Object.entries(WALLS))(
    'a wall %s takes ten times as long when it is ten times as high, not a hundred times',
    (_, wall) => {
      const time = (text: string) => {
        const begun = performance.now();
        try {
          parseSubtitles(text, false);
        } catch (error) {
          expect(error).toMatchObject({ code: 'invalid-subtitles' });
        }
        return performance.now() - begun;
      };
      const [low, high] = [wall(20_000), wall(200_000)];
      time(low);
      // What is short is as long as the clock and the collector make it.
      const once = Math.max(10, time(low));
      expect(time(high)).toBeLessThan(40 * once);
    },
  );

  test('a file that is too large is refused before it is read', async () => {
    const file = {
      name: 'a.srt',
      size: 5_000_001,
      arrayBuffer: () => {
        throw new Error('was read');
      },
    } as any;
    await expect(readSubtitles(file)).rejects.toThrow(/larger than 5 MB/);
  });

  test('subtitles over the bound are counted and left out, the first stay', () => {
    const { cues, left } = parseSubtitles(
      Array.from({ length: MOST_CUES + 7 }, (_, i) => `${CUE}${i}`).join('\n\n'),
      false,
    );
    expect([cues.length, left, cues[0].text, cues.at(-1)?.text]).toEqual([MOST_CUES, 7, '0', String(MOST_CUES - 1)]);
  });

  test('a subtitle that is too long is cut between letters, and counted', () => {
    const { cues, cut } = parseSubtitles(`${CUE}${'😀'.repeat(MOST_LETTERS + 1)}\n\n${CUE}short`, false);
    expect(cut).toBe(1);
    expect(cues.map(({ text }) => text)).toEqual(['😀'.repeat(MOST_LETTERS), 'short']);
  });
});

describe('whatever a file holds', () => {
  const part = fc.constantFrom(
    '<',
    '>',
    '</i>',
    '<c.a.b>',
    '{',
    '}',
    '{\\an8}',
    '&',
    ';',
    '&lt;',
    '&amp;',
    '&x;',
    '\\',
    '\n',
    '\r\n',
    '\r',
    '\n\n',
    ' ',
    '\t',
    '\u00a0',
    '\u2028',
    '\uFEFF',
    '1',
    '-->',
    ' --> ',
    '00:00:01,000',
    '00:00:02.5',
    '99:59:59,999',
    '00:01',
    'WEBVTT',
    'NOTE',
    'STYLE',
    '😀',
    '\ud83d',
    'é',
    '\0',
    '\n\n00:00:01,000 --> 00:00:02,000\n',
    '\n\n7\n00:01.000 --> 00:02.000 align:start\n',
  );
  const text = fc
    .array(fc.oneof({ weight: 5, arbitrary: part }, fc.string({ unit: 'binary', maxLength: 8 })), { maxLength: 60 })
    .map((parts) => parts.join(''));

  test('it gives subtitles that are bounded by it, in order, or an error with a sentence', () => {
    fc.assert(
      fc.property(text, fc.boolean(), (body, vtt) => {
        const whole = vtt ? `WEBVTT\n\n${body}` : body;
        let read: ReturnType<typeof parseSubtitles>;
        try {
          read = parseSubtitles(whole, vtt);
        } catch (error) {
          expect(error).toMatchObject({ code: 'invalid-subtitles' });
          expect((error as Error).message.length).toBeLessThan(200);
          return;
        }
        expect(read.cues.length).toBeGreaterThan(0);
        expect(read.cues.reduce((sum, cue) => sum + cue.text.length, 0)).toBeLessThanOrEqual(whole.length);
        read.cues.forEach(({ start, end, text: said }, i) => {
          expect(Number.isFinite(end) && start >= 0 && end >= start && start >= (read.cues[i - 1]?.start ?? 0)).toBe(
            true,
          );
          expect(said).toBe(said.trim());
          expect(said).not.toBe('');
          expect([...said].length).toBeLessThanOrEqual(MOST_LETTERS);
        });
      }),
      { numRuns: 3_000 },
    );
  });

  test('marks are taken out as the pattern says that was used before', () => {
    fc.assert(
      fc.property(
        text.map((body) => body.replace(/[\r\n]|-->/g, '')),
        (line) => {
          const plain = line
            .replace(/<[^>]*>/g, '')
            .replace(/\{\\[^}]*\}/g, '')
            .trim();
          const entities = {
            '&amp;': '&',
            '&lt;': '<',
            '&gt;': '>',
            '&nbsp;': ' ',
            '&lrm;': '',
            '&rlm;': '',
          } as Record<string, string>;
          const said = plain
            .replace(/&\w+;/g, (entity) => entities[entity] ?? entity)
            .replace(/\s+/g, ' ')
            .trim();
          fc.pre(said !== '' && line.trim() !== '');
          expect(parseSubtitles(`00:00:01,000 --> 00:00:02,000\n${line}`, false).cues[0].text).toBe(said);
        },
      ),
      { numRuns: 2_000 },
    );
  });

  test('bytes of any kind are read or refused', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 400 }), fc.constantFrom('a.srt', 'a.vtt'), async (bytes, name) => {
        await readSubtitles(new File([bytes as Uint8Array<ArrayBuffer>], name)).catch((error) =>
          expect(error).toMatchObject({ code: 'invalid-subtitles' }),
        );
      }),
      { numRuns: 500 },
    );
  });
});

test('what was left out of a file is told with its name', async () => {
  const alert = vi.fn();
  const panels = [{ photo: 'f', crop: null }];
  const store = {
    videos: signal(new Map()),
    album: signal(new Map([['f', { id: 'f', name: 'film.mp4', video: 'v', time: 1.5, meta: null, measures: null }]])),
    page: signal({ panels, merges: [] }),
  };
  const { open } = createSubtitling({
    store,
    lettering: { addAll: async () => true },
    messages: { alert, note: vi.fn() },
  } as any);
  const cue = '00:00:01,000 --> 00:00:02,000\n';
  await open([
    new File([`${`${cue}x\n\n`.repeat(MOST_CUES + 1)}`], 'many.srt'),
    new File([`${cue}${'x'.repeat(MOST_LETTERS + 1)}`], 'long.srt'),
  ]);
  expect(alert.mock.calls).toEqual([
    [expect.stringMatching(/^many\.srt: 20000 subtitles were read; 1 more/)],
    [expect.stringMatching(/^long\.srt: a subtitle is too long/)],
  ]);
});
