/**
 * Speech times of a video, from subtitles that are imported with it. Frame selection uses them, so that the speech has
 * a matching picture. The core reads the subtitle texts later.
 */

import { MOST } from '../document/limits.ts';
import { readText } from '../engine/text-file.ts';
import { isVideo } from '../engine/video.ts';

/** Seconds, by video. */
export type Moments = ReadonlyMap<File, readonly number[]>;

/** From when to when a cue is shown. */
const CUE = /((?:\d+:)?\d{1,2}:\d{2}[.,]\d{1,3})[ \t]*-->[ \t]*((?:\d+:)?\d{1,2}:\d{2}[.,]\d{1,3})/g;

/** @param speech subtitle files; other files have no times */
export async function momentsOf(files: readonly File[], speech: readonly File[]): Promise<Moments> {
  const films = files.filter(isVideo);
  const moments = new Map<File, number[]>();
  for (const subtitles of speech) {
    if (!/\.(srt|vtt)$/i.test(subtitles.name) || subtitles.size > MOST.subtitles) continue;
    const [film] = [...films.filter(({ name }) => stem(name) === stem(subtitles.name)), ...films];
    if (!film) continue;
    // The same file is read again as subtitles, which reports what is wrong with it.
    const { text } = await readText(subtitles).catch(() => ({ text: '' }));
    const middles = [...text.matchAll(CUE)].map(([, from, to]) => (seconds(from) + seconds(to)) / 2);
    moments.set(film, [...(moments.get(film) ?? []), ...middles]);
  }
  return moments;
}

/** The name without its ending, and without a language before that. */
function stem(name: string): string {
  return name.replace(/(\.[a-z]{2,3}(-\w{2,4})?)?\.\w+$/i, '').toLowerCase();
}

function seconds(clock: string): number {
  return clock
    .replace(',', '.')
    .split(':')
    .reduce((sum, part) => 60 * sum + Number(part), 0);
}
