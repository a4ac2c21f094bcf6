/**
 * What the net thinks of the styles on the explorer's wall: asked one style after the other once they are to be sorted,
 * those in sight first. Where there is no net, or it fails, the light score sorts.
 */

import { effect, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { Progress } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Item } from './explorer-wall.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

/** Without the net no other style can be judged. */
const FATAL = new Set(['detector-missing', 'worker-lost', 'detector']);
/** What others may wait before they are sorted in, in milliseconds: a wall that never rests cannot be read. */
const REST = 1200;

/** @param app not `wanted`, the net is not asked */
export function createScores({
  engine,
  messages,
  items,
  sorted,
  wanted,
}: {
  engine: Pick<Engine, 'judges' | 'judgeStyle' | 'hasPhoto'>;
  messages: Messages;
  items: ReadonlySignal<readonly Item[]>;
  sorted: ReadonlySignal<boolean>;
  wanted: boolean;
}) {
  /** Scores from 1 to 10 times the picture's novelty, by style; what failed is null. */
  const known: Map<string, number | null> = new Map();
  /** Those that the wall is sorted by. */
  const judged: Signal<ReadonlyMap<string, number | null>> = signal(new Map());
  const progress: Signal<Progress | null> = signal(null);
  const off = signal(!wanted || !engine.judges);
  const paused = signal(false);
  /** Styles that are in sight, told by the view. */
  const visible: Set<string> = new Set();
  let running: AbortController | null = null;

  effect(() => {
    if (!sorted.value) {
      paused.value = false;
      stop();
    } else if (!off.value && !paused.value && items.value.length > 0) void run();
  });

  return { judged, progress, off, visible, rank, pause, forget };

  /** What an item is sorted by: those that the net has judged come first. */
  function rank({ style, score }: Item) {
    const judgement = judged.value.get(style.id);
    return judgement ? 1 + judgement : score;
  }

  /** Leaves the rest as it is until styles are sorted anew. */
  function pause() {
    paused.value = true;
    stop();
  }

  /** Without the wall there is nothing to know. */
  function forget() {
    stop();
    known.clear();
    judged.value = new Map();
  }

  function stop() {
    running?.abort();
    running = null;
    progress.value = null;
  }

  /** The next style to ask about. */
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
        const { code, message } = error as { code?: string; message: string };
        if (code === 'cancelled') break;
        known.set(id, null);
        if (FATAL.has(code ?? '')) {
          off.value = true;
          messages.alert(strings.netFailed(message));
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
    progress.value = null;
  }
}
