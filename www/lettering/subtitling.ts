/**
 * Subtitles of a video onto the page: each goes to the panel whose frame is of its time. Files that come with the video
 * wait until its frames are read.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { cueAt, readSubtitles } from './subtitles.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { Word } from '../engine/documents.ts';
import type { Lettering } from './lettering.ts';
import type { Cue } from './subtitles.ts';
import type { Signal } from '@preact/signals';

export type Subtitling = ReturnType<typeof createSubtitling>;

/** Seconds that a frame may be before or after what is said. */
const SLACK = 0.75;

export function createSubtitling({
  store,
  lettering,
  messages,
}: {
  store: Store;
  lettering: Pick<Lettering, 'addAll'>;
  messages: Pick<Messages, 'alert' | 'note' | 'fileFailed'>;
}) {
  /** What subtitles become. */
  const kind: Signal<'caption' | 'balloon'> = signal('caption');

  return { kind, open };

  async function open(files: readonly File[]) {
    for (const file of files) {
      try {
        await put(file);
      } catch (error) {
        messages.fileFailed(file.name, (error as Error).message);
      }
    }
  }

  async function put(file: File) {
    const { cues, left, cut } = await readSubtitles(file);
    if (left > 0) messages.alert(strings.fileFailed(file.name, strings.subtitlesLeft(left, cues.length)));
    if (cut > 0) messages.alert(strings.fileFailed(file.name, strings.subtitlesCut(cut)));
    const frames = framesOf(file.name);
    if (frames.length === 0) throw new Error(strings.subtitlesNoFrames);
    const words = matched(cues, frames, kind.peek());
    if (words.length === 0) throw new Error(strings.subtitlesNoMatch);
    const added = await lettering.addAll(words);
    if (added > 0) messages.note(strings.subtitlesAdded(added));
  }

  /**
   * The panels that show a frame of the video that the subtitles are of: that of the same name, else of any.
   * @param name of the file of subtitles
   */
  function framesOf(name: string) {
    const stem = (file: string) => file.replace(/(\.[a-z]{2,3})?\.\w+$/i, '').toLowerCase();
    const videos = [...store.videos.peek().values()];
    const own = videos.filter((video) => stem(video.name) === stem(name)).map(({ key }) => key);
    const album = store.album.peek();
    const page = store.page.peek();
    const all = (page?.panels ?? []).flatMap(({ photo }, panel) => {
      const fact = album.get(photo ?? '');
      const leads = page?.merges.every((group) => !group.includes(panel) || group[0] === panel);
      return fact?.video !== undefined && fact.time !== undefined && leads
        ? [{ panel, time: fact.time, video: fact.video }]
        : [];
    });
    const matching = all.filter(({ video }) => own.includes(video));
    return matching.length > 0 ? matching : all;
  }
}

/** Words for the frames at whose times something is said; a subtitle goes to one frame only, the nearest to its middle. */
export function matched(
  cues: readonly Cue[],
  frames: readonly { panel: number; time: number }[],
  kind: 'caption' | 'balloon',
): Word[] {
  const places: Map<Cue, { panel: number; time: number }> = new Map();
  for (const frame of frames) {
    const cue = cueAt(cues, frame.time, SLACK);
    const before = cue && places.get(cue);
    const off = ({ time }: { time: number }) => Math.abs(time - ((cue?.start ?? 0) + (cue?.end ?? 0)) / 2);
    if (cue && (!before || off(frame) < off(before))) places.set(cue, frame);
  }
  return [...places].map(([{ text }, { panel }]) => ({ kind, text, panel, auto: true }));
}
