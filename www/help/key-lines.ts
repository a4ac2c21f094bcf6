/** The lines of the list of keys, made from the actions. */

import { now } from '../ui/action.ts';
import { keyNames } from '../ui/shortcut.ts';
import type { Tables } from '../ui/action.ts';

/** `keys`: each as the keyboard calls it */
export type KeyLine = { keys: string[]; does: string };

export function keyLines(actions: Tables): KeyLine[] {
  const lines: KeyLine[] = [];
  for (const action of Object.values(actions).flatMap((table) => Object.values(table))) {
    if (!action.keys) continue;
    const does = action.about ?? ('label' in action ? now(action.label) : '');
    // Only the first shortcut of a global action is listed. All keys are listed if a component handles them.
    const shortcuts = 'run' in action ? action.keys.slice(0, 1) : action.keys;
    const keys = shortcuts.flatMap((shortcut) => keyNames(shortcut));
    const last = lines.at(-1);
    if (last?.does !== does) lines.push({ keys: [...new Set(keys)], does });
    else last.keys = [...new Set([...last.keys, ...keys])];
  }
  return lines;
}
