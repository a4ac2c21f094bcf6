/** Keyboard shortcuts, such as `Shift+Mod+Z`: display form, form for assistive technology, and key events. */

import { strings } from '../strings/strings.ts';

/** Whether Cmd does here what Ctrl does elsewhere. */
const APPLE = /^(Mac|iP)/.test(globalThis.navigator?.platform ?? '');

const SIGNS: Record<string, string> = { ArrowLeft: '←', ArrowUp: '↑', ArrowRight: '→', ArrowDown: '↓', '-': '−' };

/** @returns its keys, each as its keyboard calls it */
export function keyNames(shortcut: string, apple: boolean = APPLE): string[] {
  const names: Record<string, string> = { ...SIGNS, ...strings.keyNames, Mod: apple ? '⌘' : strings.keyNames.Ctrl };
  return parts(shortcut).map((key) => names[key] ?? key);
}

/** @returns the value of `aria-keyshortcuts` */
export function ariaShortcut(shortcut: string, apple: boolean = APPLE): string {
  const names: Record<string, string> = { Mod: apple ? 'Meta' : 'Control', '+': 'Plus' };
  return parts(shortcut)
    .map((key) => names[key] ?? key)
    .join('+');
}

/**
 * Shortcuts of a key event. Ctrl and Cmd both count as `Mod`, because keyboards are used with different systems.
 * @returns the matching shortcuts, the closest first: a character may need Shift
 */
export function pressed({ key, shiftKey, ctrlKey, metaKey }: KeyboardEvent): string[] {
  const name = key === ' ' ? 'Space' : key.length === 1 ? key.toUpperCase() : key;
  const held = ctrlKey || metaKey ? `Mod+${name}` : name;
  return shiftKey ? [`Shift+${held}`, held] : [held];
}

/** A plus at the end is a key. */
function parts(shortcut: string) {
  return shortcut.split(/\+(?=.)/);
}
