// @ts-check
/**
 * Videos in: each becomes a number of frames, spread evenly over it or over a stretch of it. A frame is a photo from
 * then on; the video stays known, so that other frames can be taken.
 */

import { strings } from '../strings.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./album.js').Video} Video */

/** Frames taken of a video unless told: four times as many as the first page shows, for some are alike or blurred. */
export const FRAMES = 24;

/**
 * @param {{ store: Store, engine: Pick<import('../engine/engine.js').Engine, 'importVideo'>, intake: import('./intake.js').Intake }} app
 */
export function createFrames({ store, engine, intake }) {
  return { open, read, resample };

  /**
   * @param {File} file
   * @param {Partial<Video> & { frames?: number }} [wish]
   * @returns {Video}
   */
  function open(file, { frames = FRAMES, ...wish } = {}) {
    const ids = intake.freshIds(frames);
    const video = { key: ids[0], name: file.name, file, ids, duration: null, start: 0, end: null, ...wish };
    store.videos.value = new Map(store.videos.peek()).set(video.key, video);
    for (const id of ids) store.know({ id, name: file.name, meta: null, measures: null });
    return video;
  }

  /**
   * @param {Video} video
   * @param {AbortSignal} signal
   * @returns {Promise<string[]>} the frames that came: a short video has fewer than were asked for
   */
  async function read({ key, file, ids, start, end }, signal) {
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
   * @param {string} key
   * @param {{ start: number, end: number, frames: number }} wish seconds, and how many
   * @param {{ gesture: string, signal: AbortSignal }} how the step of the undo that it is
   */
  async function resample(key, { start, end, frames }, { gesture, signal }) {
    const old = store.videos.peek().get(key);
    if (!old) return;
    const video = open(old.file, { frames, duration: old.duration, start, end });
    intake.count(0, frames);
    store.change({ type: 'add-photos', ids: [...video.ids], gesture });
    if ((await read(video, signal)).length === 0) return;
    // The video before stays known: undo brings its frames back.
    store.change({ type: 'remove-photos', ids: old.ids, gesture });
  }

  /** @param {string} key @param {Partial<Video>} news */
  function know(key, news) {
    const video = store.videos.peek().get(key);
    if (video) store.videos.value = new Map(store.videos.peek()).set(key, { ...video, ...news });
  }

  /** @param {string} key */
  function forget(key) {
    store.videos.value = new Map([...store.videos.peek()].filter(([other]) => other !== key));
  }
}
