/**
 * Keeps a preview up to date. One image is drawn at a time, and the next one uses the latest style. So the worker is
 * never idle during a drag, and requests do not queue up. After the drag, the cards get their images, and the preview
 * is drawn in full size.
 */

import { createTimer } from '../engine/scheduler.ts';
import type { Designed } from '../engine/design.ts';
import type { Style } from '../engine/types.ts';
import type { Subject } from './preview-subjects.ts';

/** `full`: the width of the preview on the screen */
type Wish = { style: Style; width: number; height: number; full: number };

/** Time in ms without changes until full-size images are drawn. */
const REST = 140;
/** Maximum number of pending pictures. */
const AHEAD = 2;
/** The longer side of the pictures on the cards. */
const CARD = 176;

/** @param options `cards`: whether the cards need pictures */
export function createPreviewLoop({
  draw: drawOne,
  drawCards,
  drawWhole,
  cards,
  onPicture,
  onStages,
  onBusy,
  onError,
}: Pick<Subject, 'draw' | 'drawCards' | 'drawWhole'> & {
  cards: () => boolean;
  onPicture: (picture: { bitmap: ImageBitmap }) => void;
  onStages: (designed: Designed) => void;
  onBusy: (busy: boolean) => void;
  onError: (error: Error) => void;
}) {
  let wanted: Wish | null = null;
  /** The last request. */
  let sent: Wish | null = null;
  let flying = 0;
  const timer = createTimer();
  let stop = new AbortController();

  return {
    show(wish: Wish) {
      wanted = wish;
      stop.abort();
      timer.stop();
      onBusy(true);
      next();
    },
    dispose() {
      wanted = null;
      stop.abort();
      timer.stop();
    },
  };

  function next() {
    if (wanted && sent !== wanted && flying < AHEAD) void draw(wanted);
    else if (wanted && flying === 0) timer.start(REST, refine);
  }

  async function draw(wish: Wish) {
    const { style, width, height } = wish;
    sent = wish;
    flying += 1;
    try {
      const picture = await drawOne(style, { width, height });
      if (wanted) onPicture(picture);
    } catch (error) {
      tell(error);
    }
    flying -= 1;
    next();
  }

  async function refine() {
    const wish = wanted as Wish;
    const { style, width, height, full } = wish;
    stop = new AbortController();
    const { signal } = stop;
    try {
      if (cards()) {
        const { designed, whole } = await drawCards(style, { width, height, stages: CARD }, { signal });
        if (wanted === wish) {
          if (whole) onPicture(designed);
          onStages(designed);
        }
      }
      if (full > width * 1.05 && wanted === wish) {
        const size = { width: full, height: Math.max(1, Math.round((full * height) / width)) };
        const picture = await drawWhole(style, size, { signal });
        if (wanted === wish) onPicture(picture);
      }
    } catch (error) {
      tell(error);
    }
    if (wanted === wish) onBusy(false);
  }

  function tell(error: unknown) {
    const { code } = error as { code?: string };
    if (code !== 'cancelled' && wanted) onError(error as Error);
  }
}
