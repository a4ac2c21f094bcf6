// @ts-check
/**
 * A panel that shows a frame of a video can show an earlier or a later one: the frame takes the place of the other in
 * the tray and on the page. Presses that come while a frame is read add up.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings.js';
import { grown } from './merging.js';

/** @typedef {import('./album.js').Fact} Fact */
/** @typedef {ReturnType<typeof createScrubbing>} Scrubbing */

/** Seconds of a press: two or three frames of most films. */
export const STEP = 0.1;
export const LARGE_STEP = 1;

/**
 * @param {{
 *   store: import('./store.js').Store, pages: import('./pages.js').Pages, reading: import('./reading.js').Reading,
 *   engine: Pick<import('../engine/engine.js').Engine, 'importVideo'>, messages: Pick<import('./messages.js').Messages, 'fileFailed'>,
 * }} app
 */
export function createScrubbing({ store, pages, reading, engine, messages }) {
  /** Seconds still to go, and in which panel. */
  let pending = { panel: -1, seconds: 0, gesture: '' };
  const busy = signal(false);

  return { busy, isFrame, nudge };

  /** Whether a panel shows a frame of a video. @param {number} panel */
  function isFrame(panel) {
    return sourceOf(panel) !== null;
  }

  /**
   * @param {number} panel
   * @param {number} seconds forward, or back where negative
   * @param {string} gesture the step of the undo
   */
  async function nudge(panel, seconds, gesture) {
    pending = { panel, seconds: (pending.panel === panel ? pending.seconds : 0) + seconds, gesture };
    if (busy.peek()) return;
    busy.value = true;
    try {
      while (Math.abs(pending.seconds) > 1e-6) {
        const now = pending;
        pending = { ...now, seconds: 0 };
        await go(now);
      }
    } finally {
      busy.value = false;
    }
  }

  /** @param {typeof pending} step */
  async function go({ panel, seconds, gesture }) {
    const source = sourceOf(panel);
    if (!source) return;
    const { fact, video } = source;
    const last = Math.max(0, (video.duration ?? Infinity) - STEP / 2);
    const time = Math.min(last, Math.max(0, fact.time + seconds));
    if (time === fact.time) return;
    const [id] = reading.freshIds(1);
    try {
      await engine.importVideo(video.file, {
        ids: [id],
        start: time,
        end: time,
        onPhoto: (_, { measures: _measures, ...meta }) => {
          // A frame that a person looked for is not set aside for being like its neighbours.
          store.know({ id, name: strings.frameName(video.name, time), meta, measures: null, video: video.key, time });
        },
      });
    } catch (error) {
      const { code, message } = /** @type {{ code: string, message: string }} */ (error);
      messages.fileFailed(video.name, strings.reasons[code] ?? message);
    }
    if (store.album.peek().get(id)?.meta) exchange(fact.id, id, video.key, gesture);
  }

  /**
   * @param {string} old
   * @param {string} fresh
   * @param {string} key
   * @param {string} gesture
   */
  function exchange(old, fresh, key, gesture) {
    const videos = store.videos.peek();
    const video = videos.get(key);
    if (video) store.videos.value = new Map(videos).set(key, { ...video, ids: [...video.ids, fresh] });
    store.change({ type: 'exchange-photo', id: old, by: fresh, gesture });
    const page = store.page.peek();
    if (!page) return;
    const swap = (/** @type {string | null} */ photo) => (photo === old ? fresh : photo);
    const panels = page.panels.map((use) => ({ ...use, photo: swap(use.photo) }));
    pages.amend({ ...page, panels, order: page.order.map((photo) => swap(photo) ?? photo) }, { gesture });
  }

  /** @param {number} panel */
  function sourceOf(panel) {
    const page = store.page.value;
    const use = page?.panels[page ? grown([panel], page)[0] : 0];
    const fact = use?.photo ? store.album.value.get(use.photo) : undefined;
    const video = fact?.video === undefined ? undefined : store.videos.value.get(fact.video);
    if (!fact || !video || fact.time === undefined) return null;
    return { fact: /** @type {Fact & { time: number }} */ (fact), video };
  }
}
