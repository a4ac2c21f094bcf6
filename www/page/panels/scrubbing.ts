/**
 * A panel with a video frame can show an earlier or later frame. The new frame replaces the old one in the tray and on
 * the page. Key presses that arrive while a frame is read are added up.
 */

import { signal } from '@preact/signals';
import { strings } from '../../strings/strings.ts';
import { grown } from './merging.ts';
import { explain } from '../../ui/explain.ts';
import type { Messages } from '../../ui/messages.ts';
import type { Fact } from '../../document/album.ts';
import type { Pages } from '../../document/pages.ts';
import type { Store } from '../../document/store.ts';
import type { Engine } from '../../engine/engine.ts';
import type { Reading } from '../../photos/reading.ts';

export type Scrubbing = ReturnType<typeof createScrubbing>;

/** Seconds per key press: two or three frames of most videos. */
export const STEP = 0.1;
export const LARGE_STEP = 1;

export function createScrubbing({
  store,
  pages,
  reading,
  engine,
  messages,
}: {
  store: Store;
  pages: Pages;
  reading: Reading;
  engine: Pick<Engine, 'importVideo'>;
  messages: Pick<Messages, 'fileFailed'>;
}) {
  /** Remaining seconds, and their panel. */
  let pending = { panel: -1, seconds: 0, gesture: '' };
  const busy = signal(false);

  return { busy, isFrame, nudge };

  /** Whether a panel shows a frame of a video. */
  function isFrame(panel: number) {
    return sourceOf(panel) !== null;
  }

  /**
   * @param seconds forward, or back where negative
   * @param gesture the step of the undo
   */
  async function nudge(panel: number, seconds: number, gesture: string) {
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

  async function go({ panel, seconds, gesture }: typeof pending) {
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
          // A frame that the user chose is never excluded as a near-duplicate.
          store.know({ id, name: strings.frameName(video.name, time), meta, measures: null, video: video.key, time });
        },
      });
    } catch (error) {
      messages.fileFailed(video.name, explain(error));
    }
    if (store.album.peek().get(id)?.meta) exchange(fact.id, id, video.key, gesture);
  }

  function exchange(old: string, fresh: string, key: string, gesture: string) {
    const videos = store.videos.peek();
    const video = videos.get(key);
    if (video) store.videos.value = new Map(videos).set(key, { ...video, ids: [...video.ids, fresh] });
    store.change({ type: 'exchange-photo', id: old, by: fresh, gesture });
    pages.edit({ type: 'recrop', gesture });
  }

  function sourceOf(panel: number) {
    const page = store.page.value;
    const use = page?.panels[page ? grown([panel], page)[0] : 0];
    const fact = use?.photo ? store.album.value.get(use.photo) : undefined;
    const video = fact?.video === undefined ? undefined : store.videos.value.get(fact.video);
    if (!fact || !video || fact.time === undefined) return null;
    return { fact: fact as Fact & { time: number }, video };
  }
}
