/**
 * Keys of a focused panel. Arrows go to the next panel, Shift+Enter selects it, plus and minus zoom its photo. After
 * Enter, arrows move the photo until Enter or Escape. The same keys set a focus point.
 */

import { useRef } from 'preact/hooks';
import { useApp } from '../../ui/context.ts';
import { neighbour, WAYS } from './panel-shape.ts';
import { strings } from '../../strings/strings.ts';
import { pressed } from '../../ui/shortcut.ts';
import type { Mode } from './framing.ts';
import type { PanelShape } from './panel-shape.ts';
import type { OwnKeys } from '../../ui/action.ts';
import type { PanelAction } from './panel-actions.ts';

/** Step of an arrow key when it moves a photo, as a fraction of the panel, and with Shift. */
const STEP = 0.02;
const LARGE_STEP = 0.1;

type Deed = (gesture: string) => void;

export const WALK_KEYS: OwnKeys = {
  keys: ['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown'],
  about: strings.keyAbout.walk,
};
export const FRAME_KEYS: OwnKeys = { keys: ['Enter'], about: strings.keyAbout.frame };
export const CHOOSE_KEYS: OwnKeys = { keys: ['Shift+Enter'], about: strings.keyAbout.choose };

export function usePanelKeys({ panels, go }: { panels: readonly PanelShape[]; go: (panel: number) => void }) {
  const { framing, selection, actions } = useApp();
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

  function inMode(event: KeyboardEvent, mode: Mode): Deed | undefined {
    const { key, shiftKey } = event;
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
    return way ? plain(event, mode.panel) : acted(event, mode.panel);
  }

  function plain(event: KeyboardEvent, panel: number): Deed | undefined {
    const { key, shiftKey } = event;
    const way = WAYS[key];
    const mode = framing.mode.peek();
    if (way) return () => go(neighbour(panels, panel, way));
    if (key === 'Enter' || key === ' ') {
      if (framing.placing.peek() !== null) return () => void framing.placeIn(panel);
      if (mode?.kind === 'swap') return () => framing.swapWith(panel);
      if ((key === 'Enter' && shiftKey) || selection.several.peek()) return () => selection.toggle(panel);
      if (key === 'Enter' && !framing.isLocked(panel))
        return () => {
          framing.mode.value = { kind: 'frame', panel };
        };
    }
    return acted(event, panel);
  }

  /** Actions that also have a button. */
  function acted(event: KeyboardEvent, panel: number): Deed | undefined {
    const shortcuts = pressed(event);
    const table: Record<string, PanelAction | OwnKeys> = actions.panels;
    for (const action of Object.values(table)) {
      if (!('onPanel' in action) || !action.keys?.some((keys) => shortcuts.includes(keys))) continue;
      if (action.allows && !action.allows(panel)) continue;
      return (gesture) => action.onPanel?.(panel, { gesture, large: event.shiftKey });
    }
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
