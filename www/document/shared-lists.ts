/**
 * The lists that all projects have in common: a person's own styles, favourites and layouts. They are a part of each
 * project, so that undo reaches them; what another project or another tab did to them is carried into every state of
 * the history, so that no undo here takes it back.
 */

import { MOST } from './limits.ts';
import type { History } from './history.ts';
import type { Project } from './project.ts';

export type SharedLists = Pick<Project, 'mine' | 'favourites' | 'ownLayouts'>;
type Item = { id: string };

export const SHARED: readonly (keyof SharedLists)[] = ['mine', 'favourites', 'ownLayouts'];

/**
 * @param lists as they are now
 * @returns the same object when it had them already
 */
export function rebased(history: History, lists: Partial<SharedLists>): History {
  const news = SHARED.filter((field) => lists[field] !== undefined && !same(lists[field], history.present[field]));
  if (news.length === 0) return history;
  /** A list that many states share stays shared. */
  const made: Map<unknown, readonly Item[]> = new Map();
  const carry = (project: Project) => {
    const changed = news.map((field) => {
      const list = project[field];
      const known = made.get(list) ?? carried(list, history.present[field], lists[field] as readonly Item[]);
      made.set(list, known);
      return [field, known];
    });
    return { ...project, ...Object.fromEntries(changed) };
  };
  return {
    ...history,
    past: history.past.map(carry),
    present: carry(history.present),
    future: history.future.map(carry),
  };
}

/** What was done between two states of a list, done to another state of it. */
export function carried<T extends Item>(list: readonly T[], before: readonly T[], after: readonly T[]): readonly T[] {
  if (same(list, before)) return after;
  const was = new Map(before.map((item) => [item.id, item]));
  const is = new Map(after.map((item) => [item.id, item]));
  const fresh = after.filter((item) => !same(item, was.get(item.id)));
  const touched = new Set([
    ...fresh.map(({ id }) => id),
    ...before.filter(({ id }) => !is.has(id)).map(({ id }) => id),
  ]);
  if (touched.size === 0) return list;
  return [...fresh, ...list.filter(({ id }) => !touched.has(id))].slice(0, MOST.styles);
}

/** @param project whose own styles and layouts are added */
export function joined(project: SharedLists, lists: Partial<SharedLists>): Partial<SharedLists> {
  return Object.fromEntries(
    SHARED.map((field) => {
      const there = new Set(lists[field]?.map(({ id }) => id));
      return [
        field,
        [...(lists[field] ?? []), ...project[field].filter(({ id }) => !there.has(id))].slice(0, MOST.styles),
      ];
    }),
  );
}

function same(a: unknown, b: unknown) {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
