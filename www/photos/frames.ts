/**
 * Videos in: each becomes a number of frames, spread evenly over it or over a stretch of it. A frame is a photo from
 * then on; the video stays known, so that other frames can be taken.
 */

import { strings } from '../strings/strings.ts';
import type { Video } from '../document/album.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Intake } from './intake.ts';

/** Frames taken of a video unless told: four times as many as the first page shows, for some are alike or blurred. */
export const FRAMES = 24;

export function createFrames({
  store,
  engine,
  intake,
}: {
  store: Store;
  engine: Pick<Engine, 'importVideo'>;
  intake: Intake;
}) {
  return { open, read, resample };

  function open(file: File, { frames = FRAMES, ...wish }: Partial<Video> & { frames?: number } = {}): Video {
    const ids = intake.freshIds(frames);
    const video = { key: ids[0], name: file.name, file, ids, duration: null, start: 0, end: null, ...wish };
    store.videos.value = new Map(store.videos.peek()).set(video.key, video);
    for (const id of ids) store.know({ id, name: file.name, meta: null, measures: null });
    return video;
  }

  /** @returns the frames that came: a short video has fewer than were asked for */
  async function read({ key, file, ids, start, end }: Video, signal: AbortSignal): Promise<string[]> {
    let got = 0;
    try {
      await engine.importVideo(file, {
        ids: [...ids],
        leading: ids.filter(intake.isShown),
        start,
        end: end ?? undefined,
        signal,
        onAbout: ({ duration }) => know(key, { duration, end: end ?? duration }),
        onPhoto: (id, meta, time) => {
          got += 1;
          intake.arrived(id, meta, { name: strings.frameName(file.name, time), video: key, time });
          intake.count(1, 0);
        },
      });
    } catch (error) {
      intake.failed(file, error);
    }
    const came = intake.leaveOut(ids);
    if (came.length > 0) know(key, { ids: came });
    else forget(key);
    intake.count(ids.length - got, 0);
    return came;
  }

  /**
   * Takes other frames in place of those that are there.
   * @param wish seconds, and how many
   * @param how the step of the undo that it is
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
    if ((await read(video, signal)).length === 0) return;
    // The video before stays known: undo brings its frames back.
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
