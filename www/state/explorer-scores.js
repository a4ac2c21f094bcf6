// @ts-check
/**
 * What the net thinks of the styles on the explorer's wall: asked one style after the other once they are to be sorted,
 * those in sight first. Where there is no net, or it fails, the light score sorts.
 */

import { effect, signal } from '@preact/signals';
import { strings } from '../strings.js';

/** @typedef {import('./explorer-wall.js').Item} Item */
/** @typedef {ReturnType<typeof createScores>} Scores */

/** Without the net no other style can be judged. */
const FATAL = new Set(['detector-missing', 'worker-lost', 'detector']);
/** What others may wait before they are sorted in, in milliseconds: a wall that never rests cannot be read. */
const REST = 1200;

/**
 * @param {{
 *   engine: Pick<import('../engine/engine.js').Engine, 'judges' | 'judgeStyle' | 'hasPhoto'>, messages: import('./messages.js').Messages,
 *   items: import('@preact/signals').ReadonlySignal<readonly Item[]>, sorted: import('@preact/signals').ReadonlySignal<boolean>,
 *   wanted: boolean,
 * }} app not `wanted`, the net is not asked
 */
export function createScores({ engine, messages, items, sorted, wanted }) {
  /** Scores from 1 to 10 times the picture's novelty, by style; what failed is null. @type {Map<string, number | null>} */
  const known = new Map();
  /** Those that the wall is sorted by. @type {import('@preact/signals').Signal<ReadonlyMap<string, number | null>>} */
  const judged = signal(new Map());
  /** @type {import('@preact/signals').Signal<import('./store.js').Progress | null>} */
  const progress = signal(null);
  const off = signal(!wanted || !engine.judges);
  const paused = signal(false);
  /** Styles that are in sight, told by the view. @type {Set<string>} */
  const visible = new Set();
  /** @type {AbortController | null} */
  let running = null;

  effect(() => {
    if (!sorted.value) {
      paused.value = false;
      stop();
    } else if (!off.value && !paused.value && items.value.length > 0) void run();
  });

  return { judged, progress, off, visible, rank, pause, forget };

  /** What an item is sorted by: those that the net has judged come first. @param {Item} item */
  function rank({ style, score }) {
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

  /** The next style to ask about. @returns {Item | undefined} */
  function next() {
    const open = items.peek().filter(({ style, photo }) => !known.has(style.id) && engine.hasPhoto(photo.id));
    return open.find(({ style }) => visible.has(style.id)) ?? open[0];
  }

  async function run() {
    if (running || !next()) return;
    const mine = new AbortController();
    running = mine;
    let shown = performance.now();
    for (let item = next(); item && !mine.signal.aborted; item = next()) {
      const { style: { id }, photo, novelty } = item;
      progress.value = { done: items.peek().filter(({ style }) => known.has(style.id)).length, total: items.peek().length };
      try {
        const mean = await engine.judgeStyle(photo.id, item.style, photo, { signal: mine.signal });
        if (!mine.signal.aborted) known.set(id, mean * novelty);
      } catch (error) {
        const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
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
