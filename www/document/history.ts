/**
 * Undo and redo as lists of whole projects (ids only, never pixels, so a project is small), and the pages shown
 * so far, which are kept even when an undo goes back before them: what was loved a minute ago is never lost.
 */

import { EMPTY_PROJECT, reduce } from './project.ts';
import { rebased } from './shared-lists.ts';
import { sheetsOf } from './sheets.ts';
import type { Action, PageDocument, Project } from './project.ts';
import type { SharedLists } from './shared-lists.ts';
import type { Sheet } from './sheets.ts';

/** A page that was shown; `from` is the page that it was made from, `sheet` its place in the storyboard, 0 unless told. */
export type Shown = { id: number; page: PageDocument; from?: number; sheet?: number };

/** `gesture` names the edit that the last step belongs to, such as one drag of a slider */
export type History = {
  past: readonly Project[];
  present: Project;
  future: readonly Project[];
  shown: readonly Shown[];
  gesture: string | null;
};

/**
 * What happens to a history: an action on the project, with how it counts, or a step through time.
 * `silent` amends the present without a step (a page that is still growing); a step with the `gesture` of the
 * step before joins it.
 * `share` tells a list that all projects have in common, as it is now outside of this one: no step, at no time undone.
 */
export type Change =
  | (Action & { silent?: boolean; gesture?: string })
  | { type: 'undo' }
  | { type: 'redo' }
  | { type: 'share'; lists: Partial<SharedLists> };

const MOST_STEPS = 500;
/** Beyond so many the oldest go, favourites never. */
const MOST_SHOWN = 1000;

export const EMPTY_HISTORY: History = Object.freeze({
  past: Object.freeze([]),
  present: EMPTY_PROJECT,
  future: Object.freeze([]),
  shown: Object.freeze([]),
  gesture: null,
});

/** @returns the same object when nothing changed */
export function advance(history: History, change: Change): History {
  if (change.type === 'undo') return undo(history);
  if (change.type === 'redo') return redo(history);
  if (change.type === 'share') return rebased(history, change.lists);
  if (change.type === 'forget-photos') return forget(history, change);
  const present = reduce(history.present, change);
  if (present === history.present) return history;
  // A first page none of whose photos could be read was none.
  if (change.type === 'no-page' && change.silent)
    return { ...history, present, shown: history.shown.filter(({ id }) => id !== history.present.pageId) };
  const same = history.present.page && history.present.sheet === present.sheet;
  const shown = note(history.shown, present, same ? history.present.pageId : undefined);
  if (change.silent) return { ...history, present, shown };
  const joins = change.gesture !== undefined && change.gesture === history.gesture;
  const past = joins ? history.past : [...history.past, history.present].slice(-MOST_STEPS);
  return { past, present, future: [], shown, gesture: change.gesture ?? null };
}

/** @returns the pages shown so far in the place of the present one; all of them in a project of one page */
export function versions({ shown, present }: Pick<History, 'shown' | 'present'>): readonly Shown[] {
  return shown.filter(({ sheet = 0 }) => sheet === present.sheet);
}

/** @returns where the present page is among its versions, -1 when there is none */
export function position({ shown, present }: Pick<History, 'shown' | 'present'>): number {
  return present.page === null ? -1 : versions({ shown, present }).findIndex(({ id }) => id === present.pageId);
}

/** @returns a page id that was never used, nor any above it */
export function freshPageId({ shown, past, present, future }: History): number {
  const states = [...past, present, ...future].map(({ pageId, others }) =>
    others.reduce((most, other) => Math.max(most, other.pageId), pageId),
  );
  return greatest([...shown.map(({ id }) => id), ...states]) + 1;
}

/** @returns an id for a place in the storyboard that was never used, nor any above it */
export function freshSheet({ shown, past, present, future }: History): number {
  const states = [...past, present, ...future].map(({ sheet, others }) =>
    others.reduce((most, other) => Math.max(most, other.sheet), sheet),
  );
  return greatest([...shown.map(({ sheet = 0 }) => sheet), ...states]) + 1;
}

function greatest(ids: readonly number[]) {
  return ids.reduce((most, id) => Math.max(most, id), 0);
}

function undo(history: History): History {
  const present = history.past.at(-1);
  if (!present) return history;
  const past = history.past.slice(0, -1);
  return {
    past,
    present,
    future: [history.present, ...history.future],
    shown: note(history.shown, present),
    gesture: null,
  };
}

function redo(history: History): History {
  const [present, ...future] = history.future;
  if (!present) return history;
  return {
    past: [...history.past, history.present],
    present,
    future,
    shown: note(history.shown, present),
    gesture: null,
  };
}

/** A photo that could not be read is gone from all times: no undo brings it back. */
function forget(history: History, change: Action): History {
  const present = reduce(history.present, change);
  if (present === history.present) return history;
  const all = (list: readonly Project[]) => list.map((project) => reduce(project, change));
  const past = all(history.past);
  // A step that did nothing but add such photos is no step any more.
  while (past.length > 0 && JSON.stringify(past.at(-1)) === JSON.stringify(present)) past.pop();
  return { ...history, past, present, future: all(history.future) };
}

/**
 * The last state of each page counts: an edited page replaces itself, a new one goes to the end. So do the other pages
 * of a storyboard.
 * @param from the page before it
 */
function note(shown: readonly Shown[], project: Project, from?: number): readonly Shown[] {
  const sheets = sheetsOf(project);
  const stay = new Set([...project.loved, ...sheets.map(({ pageId }) => pageId)]);
  return sheets.reduce((list, one) => noteOne(list, one.sheet === project.sheet ? { ...one, from } : one, stay), shown);
}

/** @param stay pages that do not go when there are too many */
function noteOne(
  shown: readonly Shown[],
  { page, pageId, sheet, from }: Sheet & { from?: number },
  stay: ReadonlySet<number>,
): readonly Shown[] {
  const place = sheet === 0 ? {} : { sheet };
  const at = shown.findIndex(({ id }) => id === pageId);
  if (at < 0) {
    const all = [...shown, from === undefined ? { id: pageId, page, ...place } : { id: pageId, page, from, ...place }];
    if (all.length <= MOST_SHOWN) return all;
    const oldest = all.findIndex(({ id }) => !stay.has(id));
    return all.filter((_, i) => i !== Math.max(0, oldest));
  }
  if (shown[at].page === page && (shown[at].sheet ?? 0) === sheet) return shown;
  const { sheet: _before, ...entry } = shown[at];
  return shown.map((other, i) => (i === at ? { ...entry, page, ...place } : other));
}
