/**
 * Imports videos: each becomes representative frames of its shots, from the whole video or a part. Frames are photos.
 * The video stays available for other frames.
 */

import { batch } from '@preact/signals';
import { pictureEnds } from '../engine/animation-times.ts';
import { startTimecode } from '../engine/start-timecode.ts';
import { strings } from '../strings/strings.ts';
import { MOST } from '../document/limits.ts';
import type { Video } from '../document/album.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { About } from '../engine/video.ts';
import type { Messages } from '../ui/messages.ts';
import type { Intake } from './intake.ts';

/** Number of reserved frames before the shots of a video are known. Their final number follows the shots. */
export const FRAMES = 24;

/** How a change is recorded: silently with a first page, otherwise in an undo group. */
type Step = { silent: true } | { gesture: string };
/** `moments`: times in seconds of dialogue; `step` of frames beyond the reserved ones */
type How = { signal: AbortSignal; step?: () => Step; moments?: readonly number[] };

export function createFrames({
  store,
  engine,
  intake,
  messages,
}: {
  store: Store;
  engine: Pick<Engine, 'importVideo'>;
  intake: Intake;
  messages: Pick<Messages, 'fileFailed'>;
}) {
  return { open, read, resample };

  /** @param wish `frames`: how many places it is given */
  function open(file: File, { frames = FRAMES, ...wish }: Partial<Video> & { frames?: number } = {}): Video {
    const ids = intake.freshIds(frames);
    const video = { key: ids[0], name: file.name, file, ids, duration: null, start: 0, end: null, ...wish };
    store.videos.value = new Map(store.videos.peek()).set(video.key, video);
    for (const id of ids) store.know({ id, name: file.name, meta: null, measures: null });
    return video;
  }

  /** the extracted frames; short videos have fewer */
  async function read(video: Video, how: How & { count?: number }): Promise<string[]> {
    const { key, file, start, end } = video;
    const all = [...video.ids];
    let [got, expected] = [0, all.length];
    try {
      const timecode = await startTimecode(file);
      if (timecode) know(key, { timecode });
      await engine.importVideo(file, {
        ids: [...video.ids],
        leading: video.ids.filter(intake.isShown),
        ...(await wishOf(video, how)),
        start,
        end: end ?? undefined,
        signal: how.signal,
        more: () => another(key, file, how.step, all),
        onAbout: (about) => {
          told(key, file, about);
          number(video, about.shots ?? []);
          if (about.frames === undefined) return;
          intake.count(0, about.frames - expected);
          expected = about.frames;
        },
        onPhoto: (id, meta, time, shot) => {
          got += 1;
          intake.arrived(id, meta, { more: { name: strings.frameName(file.name, time), video: key, time, shot } });
          intake.count(1, 0);
        },
      });
    } catch (error) {
      intake.failed(file, error);
    }
    looked(key, undefined);
    const came = intake.leaveOut(all);
    if (came.length > 0) know(key, { ids: came });
    else forget(key);
    intake.count(expected - got, 0);
    return came;
  }

  /** The frames to request: existing frames are extracted again at their times, all others are selected by shots. */
  async function wishOf({ ids, duration, start, end, file }: Video, { count, moments }: How & { count?: number }) {
    const times = ids.map((id) => store.album.peek().get(id)?.time);
    if (duration !== null && times.some((time) => time !== undefined)) {
      const length = (end ?? duration) - start;
      return { times: times.map((time, i) => time ?? start + ((i + 0.5) / ids.length) * length) };
    }
    // A picture that moves has no shots.
    return (await pictureEnds(file)).length > 0 ? {} : { shots: true, count: count ?? 0, moments };
  }

  /** A place for one frame more. */
  function another(key: string, file: File, step: How['step'] = () => ({ silent: true }), all: string[]) {
    if (store.tray.peek().length >= MOST.photos) return undefined;
    const [id] = intake.freshIds(1);
    all.push(id);
    batch(() => {
      store.know({ id, name: file.name, meta: null, measures: null });
      store.change({ type: 'add-photos', ids: [id], ...step() });
      know(key, { ids: [...all] });
    });
    return id;
  }

  function told(key: string, file: File, { duration, whole, looked: part }: About) {
    const video = store.videos.peek().get(key);
    if (video && video.duration !== duration) know(key, { duration, end: video.end ?? duration });
    if (whole !== undefined) {
      const { name } = file;
      const text = strings.filmReaches({ name, till: strings.clock(duration), whole: strings.clock(whole) });
      messages.fileFailed(name, text, { text, isUsed: true });
    }
    if (part !== undefined) looked(key, part < 1 ? { name: file.name, part } : undefined);
  }

  /** Updates the shot numbers of frames that were extracted before the shots were known. */
  function number({ ids }: Video, shots: NonNullable<About['shots']>) {
    batch(() => {
      for (const [index, shot] of shots) {
        const fact = store.album.peek().get(ids[index]);
        if (fact && fact.shot !== shot) store.know({ ...fact, shot });
      }
    });
  }

  function looked(key: string, news: { name: string; part: number } | undefined) {
    const all = new Map(store.looking.peek());
    if (news) all.set(key, news);
    else if (!all.delete(key)) return;
    store.looking.value = all;
  }

  /**
   * Replaces the frames of a video.
   * @param wish seconds, and how many
   * @param how the undo group
   */
  async function resample(
    key: string,
    { start, end, frames }: { start: number; end: number; frames: number },
    { gesture, signal }: { gesture: string; signal: AbortSignal },
  ) {
    const old = store.videos.peek().get(key);
    if (!old) return;
    const video = open(old.file, { frames, duration: old.duration, start, end });
    intake.count(0, frames);
    store.change({ type: 'add-photos', ids: [...video.ids], gesture });
    const came = await read(video, { signal, count: frames, step: () => ({ gesture }) });
    if (came.length === 0) return;
    // The film before stays known: undo brings its frames back.
    store.change({ type: 'remove-photos', ids: old.ids, gesture });
  }

  function know(key: string, news: Partial<Video>) {
    const video = store.videos.peek().get(key);
    if (video) store.videos.value = new Map(store.videos.peek()).set(key, { ...video, ...news });
  }

  function forget(key: string) {
    store.videos.value = new Map([...store.videos.peek()].filter(([other]) => other !== key));
  }
}
