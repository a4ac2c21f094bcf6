/**
 * Speech times of a video, from subtitles that are imported with it. Frame selection uses them, so that the speech has
 * a matching picture. The core reads the subtitle texts later.
 */

import { MOST } from '../document/limits.ts';
import { hasRole } from '../engine/file-kinds.ts';
import { readText } from '../engine/text-file.ts';
import { textModule } from '../engine/text-module.ts';
import { isVideo } from '../engine/video.ts';
import type { Texts } from '../engine/text-module.ts';

/** Seconds, by video. */
export type Moments = ReadonlyMap<File, readonly number[]>;

/** @param speech subtitle files; other files have no times */
export async function momentsOf(
  files: readonly File[],
  speech: readonly File[],
  texts: () => Promise<Pick<Texts, 'middles'>> = textModule,
): Promise<Moments> {
  const films = files.filter(isVideo);
  const moments = new Map<File, number[]>();
  for (const subtitles of speech) {
    if (!hasRole(subtitles.name, 'subtitles') || subtitles.size > MOST.subtitles) continue;
    const [film] = [...films.filter(({ name }) => stem(name) === stem(subtitles.name)), ...films];
    if (!film) continue;
    moments.set(film, [...(moments.get(film) ?? []), ...(await middlesOf(subtitles, texts))]);
  }
  return moments;
}

async function middlesOf(file: File, texts: () => Promise<Pick<Texts, 'middles'>>): Promise<number[]> {
  try {
    const { text } = await readText(file);
    return [...(await texts()).middles(text, false)];
  } catch {
    return [];
  }
}

/** The name without its ending, and without a language before that. */
function stem(name: string): string {
  return name.replace(/(\.[a-z]{2,3}(-\w{2,4})?)?\.\w+$/i, '').toLowerCase();
}
