/**
 * What a person can do, told once: its button, its shortcut and its line in the list of keys are made from it. The
 * tables stand with their features and are joined in `app/actions.ts`.
 */

import { Signal } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';

/** Something that stays, or that follows from the state. */
export type Live<T> = T | ReadonlySignal<T>;

export type Action = {
  /** Its accessible name. */
  label: Live<string>;
  /** The text of its button where the label is too long. */
  short?: string;
  /** What its button tells on hovering, where that is more than the label. */
  help?: Live<string>;
  icon?: Live<string>;
  /**
   * Such as `L` or `Shift+Mod+Z`; `Mod` is Ctrl, on the keyboards of Apple Cmd. The first is told to people, the others
   * do the same.
   */
  keys?: readonly string[];
  /** Where the keys are heard: as long as nothing lies over the board, unless told; `panel` is the one with the focus. */
  heard?: 'board' | 'everywhere' | 'panel';
  /** What the list of keys says in the place of the label; neighbours that say the same share a line. */
  about?: string;
  /** Whether it can be done now; always, unless told. */
  enabled?: ReadonlySignal<boolean>;
  /** The reason why it cannot, where one is told: an empty one when it can. */
  why?: ReadonlySignal<string>;
  /** Whether what it switches is on. */
  on?: ReadonlySignal<boolean>;
  run: () => void;
  /** How it counts in the undo: each time, or together with the times just before. What is not undone has no mark. */
  undo?: 'step' | 'gesture';
};

/** Keys that a part of the page hears by itself, such as the arrows on its panels: for the list of keys. */
export type OwnKeys = Required<Pick<Action, 'keys' | 'about'>>;

export function now<T>(value: Live<T>): T {
  return value instanceof Signal ? value.value : (value as T);
}

export function isEnabled({ enabled, why }: Pick<Action, 'enabled' | 'why'>): boolean {
  return (enabled?.value ?? true) && (why?.value ?? '') === '';
}
