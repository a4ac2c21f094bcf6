/**
 * Subtitles of a video onto the page: each goes to the panel whose frame is of its time. Files that come with the video
 * wait until its frames are read.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { MOST } from '../document/limits.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { SubtitleFlaw } from '../engine/words.ts';
import type { Lettering } from './lettering.ts';
import type { Signal } from '@preact/signals';

export type Subtitling = ReturnType<typeof createSubtitling>;

export function isSubtitles({ name }: { name: string }) {
  return /\.(srt|vtt)$/i.test(name);
}

export function createSubtitling({
  store,
  lettering,
  messages,
}: {
  store: Store;
  lettering: Pick<Lettering, 'addAll' | 'ready'>;
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
    if (file.size > MOST.subtitles) throw new Error(sentence({ kind: 'large' }));
    const [bytes, letters] = await Promise.all([file.arrayBuffer(), lettering.ready()]);
    if (!letters) return;
    const frames = framesOf(file.name);
    const told = letters.subtitles(new Uint8Array(bytes), /\.vtt$/i.test(file.name), frames, kind.peek());
    if ('flaw' in told) throw new Error(sentence(told.flaw));
    const { words, cues, left, cut } = told;
    if (left > 0) messages.alert(strings.fileFailed(file.name, strings.subtitlesLeft(left, cues)));
    if (cut > 0) messages.alert(strings.fileFailed(file.name, strings.subtitlesCut(cut)));
    if (frames.length === 0) throw new Error(strings.subtitlesNoFrames);
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

function sentence(flaw: SubtitleFlaw): string {
  const says = strings.subtitleErrors;
  switch (flaw.kind) {
    case 'stray':
    case 'time':
      return says[flaw.kind](flaw.line, flaw.text);
    case 'order':
      return says.order(flaw.line);
    default:
      return says[flaw.kind];
  }
}
