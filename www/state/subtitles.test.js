// @ts-check
import { describe, expect, test } from 'vitest';
import { cueAt, isSubtitles, parseSubtitles, readSubtitles } from './subtitles.js';
import { matched } from './subtitling.js';

const SRT = '\uFEFF1\r\n00:00:01,000 --> 00:00:02,500\r\n<i>Hello</i>\r\nthere\r\n\r\n2\r\n00:01:00,5 --> 01:00:01,250\r\n{\\an8}Bye\r\n';

describe('subtitles', () => {
  test('SubRip is read, without its marks', () => {
    expect(parseSubtitles(SRT, false)).toEqual([
      { start: 1, end: 2.5, text: 'Hello there' }, { start: 60.5, end: 3601.25, text: 'Bye' },
    ]);
  });

  test('WebVTT is read, its notes, names and settings passed over', () => {
    const vtt = 'WEBVTT Kind: captions\nLanguage: en\n\nNOTE a --> remark\n\nSTYLE\n::cue { color: red }\n\nintro\n00:04.000 --> 00:05.000 align:start\n<v Anna>Tom &amp; Jerry</v>\n\n01:00:00.000 --> 01:00:01.000\n\n\n00:01.000 --> 00:02.000\nFirst';
    expect(parseSubtitles(vtt, true)).toEqual([{ start: 1, end: 2, text: 'First' }, { start: 4, end: 5, text: 'Tom & Jerry' }]);
  });

  test.each([
    ['', false, /no subtitles/],
    ['1\n00:00:01,000 > 00:00:02,000\nHi', false, /line 1: a time was expected/],
    ['1\n00:00:01 --> 00:00:02\nHi', false, /line 2: .* is not a time/],
    ['1\n00:99:01,000 --> 00:00:02,000\nHi', false, /line 2/],
    ['1\n00:00:03,000 --> 00:00:02,000\nHi', false, /ends before it starts/],
    ['1\n00:00:01,000 --> 00:00:02,000\nHi\n\nno time here\nnone', false, /line 5/],
    ['1\n', false, /line 1/],
    ['00:01.000 --> 00:02.000\nHi', true, /WEBVTT/],
    ['WEBVTT', true, /no subtitles/],
  ])('%j is an error with its reason', (text, vtt, reason) => {
    expect(() => parseSubtitles(text, vtt)).toThrow(reason);
  });

  test('files are told by their names, read in UTF-8 and UTF-16, and refused in anything else', async () => {
    expect([isSubtitles({ name: 'A.SRT' }), isSubtitles({ name: 'a.en.vtt' }), isSubtitles({ name: 'srt.jpg' })]).toEqual([true, true, false]);
    const wide = new Uint8Array(2 + 2 * SRT.length);
    new DataView(wide.buffer).setUint16(0, 0xfffe);
    [...SRT].forEach((letter, i) => new DataView(wide.buffer).setUint16(2 + 2 * i, letter.charCodeAt(0), true));
    expect(await readSubtitles(new File([wide], 'a.srt'))).toHaveLength(2);
    await expect(readSubtitles(new File([new Uint8Array([0x31, 0xe9, 0x0a])], 'a.srt'))).rejects.toMatchObject({ code: 'invalid-subtitles' });
    await expect(readSubtitles(new File(['1\0'], 'a.srt'))).rejects.toThrow(/not text/);
  });

  test('a frame has what is said at its time, or close to it', () => {
    const cues = parseSubtitles(SRT, false);
    expect(cueAt(cues, 2, 0.5)?.text).toBe('Hello there');
    expect(cueAt(cues, 2.9, 0.5)?.text).toBe('Hello there');
    expect(cueAt(cues, 5, 0.5)).toBeNull();
    expect(cueAt([], 5, 0.5)).toBeNull();
  });

  test('a subtitle goes to one frame only, the one nearest to its middle', () => {
    const frames = [{ panel: 0, time: 1.1 }, { panel: 1, time: 1.7 }, { panel: 2, time: 30 }, { panel: 3, time: 61 }];
    expect(matched(parseSubtitles(SRT, false), frames, 'caption')).toEqual([
      { kind: 'caption', text: 'Hello there', panel: 1, auto: true }, { kind: 'caption', text: 'Bye', panel: 3, auto: true },
    ]);
  });
});
