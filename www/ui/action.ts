/**
 * An action of the user, defined once. Its button, its shortcut and its entry in the shortcut list are made from it.
 * Each feature has a table of actions. `app/app.ts` joins them. An action on one entry of a list, or with the state of a
 * dialog, is made in its view, with constant values.
 */

import { Signal } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';

/** A constant value, or a value derived from the state. */
export type Live<T> = T | ReadonlySignal<T>;

export type Action = {
  /** Its accessible name. */
  label: Live<string>;
  /** Button text if the label is too long. */
  short?: string;
  /** Tooltip of the button, if it differs from the label. */
  help?: Live<string>;
  icon?: Live<string>;
  /**
   * Such as `L` or `Shift+Mod+Z`; `Mod` is Ctrl, on the keyboards of Apple Cmd. The first is shown to the user, the
   * others are alternatives.
   */
  keys?: readonly string[];
  /** Scope of the keys. Default: the app, unless a dialog is open. `panel` is the focused panel. */
  heard?: 'board' | 'everywhere' | 'panel';
  /** Entry in the shortcut list, if it differs from the label. Adjacent actions with equal entries share a line. */
  about?: string;
  /** Whether it is available. Default: yes. */
  enabled?: Live<boolean>;
  /** The reason why it is not available; empty if it is. */
  why?: Live<string>;
  /** State of a toggle. */
  on?: Live<boolean>;
  run: () => void;
  /**
   * How it counts in the undo: each time, or together with the times just before. Actions without undo have no value.
   */
  undo?: 'step' | 'gesture';
};

/** Keys that a part of the app handles separately, such as arrows on panels, for the shortcut list. */
export type OwnKeys = Required<Pick<Action, 'keys' | 'about'>>;

/** Actions by feature, as used by the list of shortcuts and the menus. */
export type Tables = Record<string, Record<string, Action | OwnKeys>>;

/** @returns each with its name, such as `page.shuffle` */
export function everyAction(tables: Tables): [string, Action][] {
  return Object.entries(tables).flatMap(([feature, table]) =>
    Object.entries(table).flatMap(([name, action]): [string, Action][] =>
      'run' in action ? [[`${feature}.${name}`, action]] : [],
    ),
  );
}

export function now<T>(value: Live<T>): T {
  return value instanceof Signal ? value.value : (value as T);
}

export function isEnabled({ enabled, why }: Pick<Action, 'enabled' | 'why'>): boolean {
  return (now(enabled) ?? true) && (now(why) ?? '') === '';
}
