/**
 * What keys do on a panel: arrows go to the next one, Shift with Enter chooses it, plus and minus zoom its photo.
 * Enter takes hold of the photo: arrows then move it, until Enter or Escape. The same keys set a focus point.
 */

import { useRef } from 'preact/hooks';
import { LARGE_STEP as LARGE_SCRUB, STEP as SCRUB } from '../../photos/scrubbing.ts';
import { useApp } from '../../app/context.ts';
import { WAYS, neighbour } from './panel-shape.ts';
import type { Mode } from './framing.ts';
import type { PanelShape } from './panel-shape.ts';

/** What an arrow moves a photo by, in parts of the panel, and with Shift. */
const STEP = 0.02;
const LARGE_STEP = 0.1;
/** What a key press enlarges a photo by. */
const ZOOM = 1.1;

export function usePanelKeys({ panels, go }: { panels: PanelShape[]; go: (panel: number) => void }) {
  const { framing, scrubbing, selection } = useApp();
  /** A key that is held, or pressed again and again, is one step of the undo until another one is pressed. */
  const last = useRef({ key: '', gesture: '' });

  return (event: KeyboardEvent, panel: number) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const mode = framing.mode.peek();
    const mine = mode?.panel === panel ? mode : null;
    const deed = mine ? inMode(event, mine) : plain(event, panel);
    if (!deed) return;
    event.preventDefault();
    event.stopPropagation();
    if (last.current.key !== `${event.key} ${panel}`)
      last.current = { key: `${event.key} ${panel}`, gesture: framing.step() };
    deed(last.current.gesture);
  };

  function inMode({ key, shiftKey }: KeyboardEvent, mode: Mode): ((gesture: string) => void) | undefined {
    const way = WAYS[key];
    const step = shiftKey ? LARGE_STEP : STEP;
    if (way && mode.kind === 'focus')
      return () => {
        framing.mode.value = { ...mode, at: moved(mode.at, way, step) };
      };
    if (way && mode.kind === 'frame') return (gesture) => pan(mode.panel, way, step, gesture);
    if (key === 'Enter' || key === ' ') {
      return () => {
        if (mode.kind === 'focus') framing.focus(mode.panel, mode.at ?? [0.5, 0.5]);
        framing.mode.value = null;
      };
    }
    return way ? plain({ key, shiftKey }, mode.panel) : zoomed(key, mode.panel);
  }

  function plain(
    { key, shiftKey }: { key: string; shiftKey: boolean },
    panel: number,
  ): ((gesture: string) => void) | undefined {
    const way = WAYS[key];
    const mode = framing.mode.peek();
    if (way) return () => go(neighbour(panels, panel, way));
    if (key === 'Enter' || key === ' ') {
      if (mode?.kind === 'swap') return () => framing.swapWith(panel);
      if ((key === 'Enter' && shiftKey) || selection.several.peek()) return () => selection.toggle(panel);
      if (key === 'Enter' && !framing.isLocked(panel))
        return () => {
          framing.mode.value = { kind: 'frame', panel };
        };
    }
    return scrubbed({ key, shiftKey }, panel) ?? zoomed(key, panel);
  }

  /** A comma and a full stop, as in film editors; with Shift a second. */
  function scrubbed(
    { key, shiftKey }: { key: string; shiftKey: boolean },
    panel: number,
  ): ((gesture: string) => void) | undefined {
    const way = { ',': -1, '<': -1, '.': 1, '>': 1 }[key];
    if (way === undefined || framing.isLocked(panel) || !scrubbing.isFrame(panel)) return undefined;
    return (gesture) => scrubbing.nudge(panel, way * (shiftKey ? LARGE_SCRUB : SCRUB), gesture);
  }

  function zoomed(key: string, panel: number) {
    if (key === '+' || key === '=') return (gesture: string) => framing.closer(panel, ZOOM, gesture);
    if (key === '-') return (gesture: string) => framing.closer(panel, 1 / ZOOM, gesture);
    if (key === '0') return () => framing.reset(panel);
    return undefined;
  }

  function pan(panel: number, [x, y]: [number, number], step: number, gesture: string) {
    const crop = framing.cropOf(panel);
    // An arrow moves the window over the photo, as it moves a caret over a text.
    if (crop) framing.pan(panel, crop, [-x * step, -y * step], gesture);
  }
}

function moved(
  [u, v]: [number, number] | undefined = [0.5, 0.5],
  [x, y]: [number, number],
  step: number,
): [number, number] {
  const clamp = (part: number) => Math.min(1, Math.max(0, part));
  return [clamp(u + x * step), clamp(v + y * step)];
}
