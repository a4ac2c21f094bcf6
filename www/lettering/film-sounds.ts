/**
 * Sound effects from the sound of a video. On request, a video is analysed, and prominent sounds near frames on pages
 * are proposed as sound effects. An added effect belongs to the photo of its frame, like subtitles, and is one undo
 * step.
 */

import { signal } from '@preact/signals';
import { MOST_SOUND } from '../engine/sounds.ts';
import { strings } from '../strings/strings.ts';
import { codeOf, explain } from '../ui/explain.ts';
import type { Messages } from '../ui/messages.ts';
import type { Video } from '../document/album.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { SoundStage } from '../engine/sounds.ts';
import type { SoundEvent, SoundWord } from '../engine/types.ts';
import type { Lettering } from './lettering.ts';
import type { Signal } from '@preact/signals';

export type FilmSounds = ReturnType<typeof createFilmSounds>;
/** State of a detection. `why`: the reason of a failure, as a sentence. */
export type Heard = { stage: SoundStage } | { why: string } | { events: readonly SoundEvent[] };
/** A sound near a frame. `taken` is the text item of this sound, if it was added. */
export type Proposal = { event: SoundEvent; photo: string; cue: string; taken: string | undefined };

/** Seconds that a sound may be away from the frame that it is drawn on. */
const NEAR = 1.5;
/** Sounds that are proposed for one frame: the loudest. */
const EACH = 3;
/** Rotation of a sound effect in degrees, as for manually added ones. */
const TURNED = -8;

export function createFilmSounds({
  store,
  engine,
  lettering,
  messages,
}: {
  store: Store;
  engine: Pick<Engine, 'hearFilm'>;
  lettering: Pick<Lettering, 'lay' | 'ready'>;
  messages: Pick<Messages, 'note'>;
}) {
  /** By file, because other frames of a video belong to another entry. */
  const heard: Signal<ReadonlyMap<File, Heard>> = signal(new Map());
  const stops = new Map<File, AbortController>();

  return { of: ({ file }: Video) => heard.value.get(file), hear, stop, proposals, take };

  async function hear({ file }: Video) {
    if (stops.has(file)) return;
    const stopping = new AbortController();
    stops.set(file, stopping);
    try {
      const events = await engine.hearFilm(file, {
        signal: stopping.signal,
        onStage: (stage) => know(file, { stage }),
      });
      know(file, { events });
    } catch (error) {
      if ((error as Error | null)?.name === 'AbortError') know(file, undefined);
      else know(file, { why: sentence(error) });
    } finally {
      stops.delete(file);
    }
  }

  function stop({ file }: Video) {
    stops.get(file)?.abort();
  }

  function know(file: File, news: Heard | undefined) {
    const all = new Map(heard.peek());
    if (news) all.set(file, news);
    else all.delete(file);
    heard.value = all;
  }

  /** @returns the sounds near frames on pages, in time order, and the number of other sounds */
  function proposals(video: Video, events: readonly SoundEvent[]): { near: Proposal[]; far: number } {
    const album = store.album.value;
    const shown = new Set(store.sheets.value.flatMap(({ panels }) => panels.map(({ photo }) => photo)));
    const frames = [...shown].flatMap((id) => {
      const fact = id === null ? undefined : album.get(id);
      return fact?.video === video.key && fact.time !== undefined ? [{ id: fact.id, time: fact.time }] : [];
    });
    const words = [...store.sheets.value.flatMap(({ words }) => words ?? []), ...(store.project.value.waiting ?? [])];
    const taken = new Map(words.flatMap(({ cue, text }) => (cue ? [[cue, text] as const] : [])));
    const groups = new Map<string, Proposal[]>();
    let far = 0;
    for (const event of [...events].sort((a, b) => b.loudness - a.loudness)) {
      const photo = nearest(event, frames);
      if (photo === undefined) {
        far += 1;
        continue;
      }
      const cue = cueOf(video, event);
      const group = groups.get(photo) ?? [];
      if (group.length < EACH) groups.set(photo, [...group, { event, photo, cue, taken: taken.get(cue) }]);
    }
    const near = [...groups.values()].flat().sort((a, b) => a.event.start - b.event.start);
    return { near, far };
  }

  async function take({ event, photo, cue }: Proposal, word: SoundWord) {
    // Without glyphs, a text item has no position.
    if (!(await lettering.ready())) return;
    const text = strings.soundWords[word];
    const turned = event.kind === 'music' ? {} : { angle: TURNED };
    const { shown } = lettering.lay([{ kind: 'effect', text, photo, panel: 0, auto: true, cue, ...turned }]);
    if (shown > 0) messages.note(strings.filmSounds.taken({ text }));
  }
}

/** A video is identified by its name, because its key changes each time a project is opened. */
function cueOf({ name }: Video, { start }: SoundEvent): string {
  return `${name} sound ${start.toFixed(3)}`;
}

/** @returns the frame during the sound, or without one the nearest frame, if it is near enough */
function nearest({ start, end }: SoundEvent, frames: readonly { id: string; time: number }[]): string | undefined {
  const away = (time: number) => Math.max(start - time, time - end, 0);
  const order = (time: number) => away(time) * 1e6 + Math.abs(time - start);
  const [first] = frames.filter(({ time }) => away(time) <= NEAR).sort((a, b) => order(a.time) - order(b.time));
  return first?.id;
}

function sentence(error: unknown): string {
  const says = strings.filmSounds;
  switch (codeOf(error)) {
    case 'sound-none':
      return says.mute;
    case 'sound-long':
      return says.long({ minutes: strings.decimal(MOST_SOUND.seconds / 60) });
    case 'sound-large':
      return says.large({ size: strings.fileSize(MOST_SOUND.bytes) });
    case 'sound-undecodable':
      return says.undecodable;
    default:
      return says.failed({ why: explain(error) });
  }
}
