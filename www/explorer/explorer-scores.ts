/**
 * The score of each style on the explorer's wall, from 0 to 100. Simple measures give a first score, until the model
 * has rated the picture. The model scores one style at a time after the user has sorted the wall, visible styles first.
 */

import { effect, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { codeOf, explain } from '../ui/explain.ts';
import type { Messages } from '../ui/messages.ts';
import type { Progress } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Item } from './explorer-wall.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

/** Without the model, no other style can be rated. */
const FATAL = new Set(['detector-missing', 'worker-lost', 'detector']);
/** Maximum delay of new scores in milliseconds, because scores that change constantly cannot be read. */
const REST = 1200;
/** Practical range of the model's ratings from 1 to 10. */
const [WORST, BEST] = [2.5, 6.5];

/** @param app `wanted`: without it, the model is not used; `complete`: called when the model has rated all styles */
export function createScores({
  engine,
  messages,
  items,
  wanted,
  complete = () => {},
}: {
  engine: Pick<Engine, 'judges' | 'judgeStyle' | 'hasPhoto'>;
  messages: Messages;
  items: ReadonlySignal<readonly Item[]>;
  wanted: boolean;
  complete?: () => void;
}) {
  /** Scores from 1 to 10 times the novelty of the image, by style; null after an error. */
  const known: Map<string, number | null> = new Map();
  /** The scores in the current order. */
  const judged: Signal<ReadonlyMap<string, number | null>> = signal(new Map());
  const progress: Signal<Progress | null> = signal(null);
  const off = signal(!wanted || !engine.judges);
  const asked = signal(false);
  /** Visible styles, from the view. */
  const visible: Set<string> = new Set();
  let running: AbortController | null = null;

  effect(() => {
    if (asked.value && !off.value && items.value.length > 0) void run();
  });

  return { judged, progress, off, visible, points, shown, ask, pause, forget };

  /** Returns the score of a style, a whole number from 0 to 100. */
  function points({ style, score }: Pick<Item, 'style' | 'score'>): number {
    const judgement = judged.value.get(style.id);
    const share = judgement ? (judgement - WORST) / (BEST - WORST) : score;
    return Math.round(100 * Math.min(1, Math.max(0, share)));
  }

  /**
   * Returns the visible score. If the model gives scores, only these are shown, so that all scores are comparable. None
   * if it is unknown.
   */
  function shown(item: Item): number | null {
    return off.value || judged.value.get(item.style.id) ? points(item) : null;
  }

  /** Rates the styles on the wall with the model. */
  function ask() {
    asked.value = true;
  }

  /** Stops the ratings until the next request. */
  function pause() {
    asked.value = false;
    stop();
  }

  /** A new wall, or the same wall on another photo, has no scores. */
  function forget() {
    pause();
    known.clear();
    judged.value = new Map();
  }

  function stop() {
    running?.abort();
    running = null;
    progress.value = null;
  }

  /** The next style to rate. */
  function next(): Item | undefined {
    const open = items.peek().filter(({ style, photo }) => !known.has(style.id) && engine.hasPhoto(photo.id));
    return open.find(({ style }) => visible.has(style.id)) ?? open[0];
  }

  async function run() {
    if (running || !next()) return;
    const mine = new AbortController();
    running = mine;
    let shown = performance.now();
    for (let item = next(); item && !mine.signal.aborted; item = next()) {
      const {
        style: { id },
        photo,
        novelty,
      } = item;
      progress.value = {
        done: items.peek().filter(({ style }) => known.has(style.id)).length,
        total: items.peek().length,
      };
      try {
        const mean = await engine.judgeStyle(photo.id, item.style, photo, { signal: mine.signal });
        if (!mine.signal.aborted) known.set(id, mean * novelty);
      } catch (error) {
        const code = codeOf(error);
        if (code === 'cancelled') break;
        known.set(id, null);
        if (FATAL.has(code)) {
          off.value = true;
          messages.alert(strings.netFailed({ why: explain(error) }));
          break;
        }
      }
      if (performance.now() - shown > REST) {
        judged.value = new Map(known);
        shown = performance.now();
      }
    }
    if (running !== mine) return;
    judged.value = new Map(known);
    running = null;
    complete();
    progress.value = null;
  }
}
