/**
 * State of the mask editor: the engine has the mask, this module has the state for the views and the commands. The
 * document changes only when the user accepts the result.
 */

import { signal } from '@preact/signals';
import type { Hand, Mending } from '../engine/brush-module.ts';
import type { Signal } from '@preact/signals';

export type Retouching = ReturnType<typeof createRetouching>;
/** Action of a press: paint, erase, or select only the subject at that point. */
export type Tool = 'add' | 'take' | 'choose';
export type Point = { x: number; y: number };

export const TOOLS: readonly Tool[] = ['add', 'take', 'choose'];
/** Radii of the brush, in photo widths. */
export const SIZES = { least: 0.005, most: 0.2, first: 0.04 };
/** Factor of the brush size per key press. */
const SIZE_STEP = 1.25;
/** Distance per arrow key in photo widths, and with Shift. */
const STEP = 0.02;
const LARGE_STEP = 0.1;

export function createRetouching(hand: Hand) {
  const tool: Signal<Tool> = signal('add');
  const size = signal(SIZES.first);
  /** Position of the brush, in fractions of the photo; null before the first move. */
  const at: Signal<Point | null> = signal(null);
  const told = signal(hand.told());
  /** Counts the changes to draw; `fine` if no stroke is in progress. */
  const seen = signal({ count: 0, fine: true });
  /** Reason why the last command had no effect. */
  const vain: Signal<'onlyOne' | 'noneHere' | 'softest' | null> = signal(null);
  /** The end of the stroke so far. */
  let last: Point | null = null;

  return {
    width: hand.width,
    height: hand.height,
    draw: hand.draw,
    steps: hand.steps,
    tool,
    size,
    at,
    told,
    vain,
    seen,
    press,
    strokeTo,
    lift,
    abandon,
    dab,
    mend,
    undo: () => changed(hand.undo()),
    redo: () => changed(hand.redo()),
    resize,
    move,
  };

  /** Starts a press at a point. @returns whether a stroke starts, or otherwise whether anything changed */
  function press(point: Point): boolean {
    at.value = point;
    if (tool.peek() === 'choose') return changed(hand.choose(point.x, point.y), 'noneHere');
    paint([point]);
    return true;
  }

  /** Goes on with the stroke through points. */
  function strokeTo(points: readonly Point[]) {
    at.value = points.at(-1) ?? at.peek();
    if (last && points.length > 0) paint([last, ...points]);
  }

  /** Ends the stroke: a step. */
  function lift(): boolean {
    if (!last) return false;
    last = null;
    return changed(hand.end());
  }

  /** Takes back the stroke under way. */
  function abandon() {
    if (!last) return;
    last = null;
    hand.abandon();
    show(true);
  }

  /** Paints at the position of the brush, or in the middle if it was never moved. */
  function dab(): boolean {
    const chooses = tool.peek() === 'choose';
    const pressed = press(at.peek() ?? { x: 0.5, y: 0.5 });
    return chooses ? pressed : lift();
  }

  function mend(how: Mending): boolean {
    last = null;
    return changed(hand.mend(how), how === 'NextFigure' ? 'onlyOne' : how === 'Feather' ? 'softest' : null);
  }

  /** @param way 1 for larger, -1 for smaller */
  function resize(way: 1 | -1) {
    size.value = Math.min(SIZES.most, Math.max(SIZES.least, size.peek() * SIZE_STEP ** way));
  }

  /** Moves the brush by the keyboard, a step each along the axes. */
  function move({ x, y }: Point, large: boolean) {
    const from = at.peek() ?? { x: 0.5, y: 0.5 };
    const step = large ? LARGE_STEP : STEP;
    const within = (part: number) => Math.min(1, Math.max(0, part));
    at.value = { x: within(from.x + x * step), y: within(from.y + (y * step * hand.width) / hand.height) };
  }

  function paint(points: readonly Point[]) {
    hand.paint(
      points.flatMap(({ x, y }) => [x, y]),
      size.peek(),
      tool.peek() === 'add',
    );
    last = points[points.length - 1];
    show(false);
  }

  /** @param reason message if nothing changed */
  function changed(whether: boolean, reason: typeof vain.value = null): boolean {
    vain.value = whether ? null : reason;
    told.value = hand.told();
    show(true);
    return whether;
  }

  function show(fine: boolean) {
    seen.value = { count: seen.peek().count + 1, fine };
  }
}
