/** Animated panels of an image: panels whose photos are frames of an available video. */

import { byPanel, picturesOf } from '../engine/figures.ts';
import { LIVING } from '../engine/living.ts';
import { drawsParts } from '../page/subjects-of.ts';
import { placeOn } from './drawn-word.ts';
import type { Moment } from '../engine/living.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { BitmapPatch } from '../engine/protocol.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';
import type { DrawnLoop } from './frames.ts';

/** Long side of the pictures of a panel, in pixels at most. */
const MOST_SIDE = 960;

export function createLoops({
  store,
  engine,
}: {
  store: Store;
  engine: Pick<Engine, 'drawLiving' | 'renderPictures'>;
}) {
  return { known, of };

  /**
   * Whether a photo is a frame of a readable video. It reads signals, because a video's duration may be known after its
   * frames.
   */
  function known(photo: string | null): boolean {
    return momentOf(photo, store.album.value, store.videos.value) !== null;
  }

  function momentOf(photo: string | null, album = store.album.peek(), videos = store.videos.peek()): Moment | null {
    const fact = photo === null ? undefined : album.get(photo);
    if (fact?.video === undefined || fact.time === undefined) return null;
    const video = videos.get(fact.video);
    return video && video.duration !== null ? { file: video.file, time: fact.time, duration: video.duration } : null;
  }

  /**
   * @param pixels of all pictures of all panels, at most
   * @param call `onDrawn` is called after each panel
   * @returns the animated panels and the panels above them, in paint order; a panel without a readable video stays
   *   still
   */
  async function of(
    document: PageDocument,
    pixels: number,
    { signal, onDrawn = () => {} }: { signal?: AbortSignal; onDrawn?: (loops: DrawnLoop[]) => void } = {},
  ): Promise<DrawnLoop[]> {
    // The subject masks are known for one frame only.
    if (drawsParts(store, document)) return [];
    const boxes = store.planner.peek()?.geometry(document.layout, document.page).panels ?? [];
    const moving = new Map(
      document.panels.flatMap(({ photo, figure }, index) => {
        const moment = momentOf(photo);
        // A breakout would appear twice, and a picture across several panels is cut for each of them.
        const still = figure || document.merges.some((group) => group.includes(index));
        return moment && !still && boxes[index] ? [[index, { moment, box: boxes[index].bounds }] as const] : [];
      }),
    );
    if (moving.size === 0) return [];
    const all = [...moving.values()].map(({ box }) => box);
    const long = Math.max(...all.map((box) => Math.max(box.width, box.height)));
    const area = all.reduce((sum, box) => sum + box.width * box.height, 0);
    const each = pixels / (LIVING.rate * LIVING.seconds);
    const width = Math.round(Math.min(MOST_SIDE / long, Math.sqrt(each / area), document.page.width));
    const drawn = new Map<number, DrawnLoop>();
    const inOrder = () => [...drawn].sort(([a], [b]) => a - b).map(([, loop]) => loop);

    /** @param pictures of one panel; animated panels have no breakout */
    async function draw(pictures: number[]) {
      const mine = moving.get(pictures[0]);
      if (mine) {
        const { moment } = mine;
        const patches = await engine.drawLiving(document, pictures[0], width, moment, { signal }).catch(orNone(signal));
        if (patches.length > 0) keep(pictures[0], patches);
      } else {
        // Pictures that lie above a moving panel are drawn again on top of it.
        const over = pictures.filter((index) =>
          [...moving].some(([below, { box }]) => below < index && overlap(box, boxes[index]?.bounds)),
        );
        const patches =
          over.length === 0 ? [] : await engine.renderPictures(document, over, width, { tier: 'work', signal });
        patches.forEach((patch, at) => keep(over[at], [patch]));
      }
    }

    function keep(index: number, patches: BitmapPatch[]) {
      const bitmaps = patches.map(({ bitmap }) => bitmap);
      drawn.set(index, { place: placeOn(document, width, patches[0]), bitmaps });
      onDrawn(inOrder());
    }

    const waiting = byPanel(document, picturesOf(document));
    const work = async () => {
      for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) await draw(next);
    };
    // One video is decoded while a panel of another one is drawn.
    await Promise.all([work(), work()]);
    return inOrder();
  }
}

/** If a video cannot be read, its panels stay still. */
function orNone(signal: AbortSignal | undefined) {
  return (error: unknown): BitmapPatch[] => {
    if (signal?.aborted) throw error;
    return [];
  };
}

/** @param b of a breakout is unknown, and counts as overlapping */
function overlap(a: Bounds, b: Bounds | undefined): boolean {
  return !b || (a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height);
}
