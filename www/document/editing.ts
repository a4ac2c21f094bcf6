/**
 * The editor of a project. The core applies edits, and this module has a readable copy of the history. Unchanged parts
 * keep their object identity, so drawing, caches and the journal can skip them.
 */

import { joinedWith } from '../engine/interned.ts';
import { VERSION } from '../engine/versions.ts';
import { EMPTY_HISTORY } from './history.ts';
import { wellFormed } from './limits.ts';
import { sheetsOf } from '../engine/sheets.ts';
import type { Editor, KeptHistory } from '../engine/core.ts';
import type { Known } from '../engine/interned.ts';
import type { Board, Difference, Intent, Loaded, PhotoMeta, Runs } from '../engine/types.ts';
import type { Change, History, Shown } from './history.ts';
import type { PageDocument, Project } from './project.ts';

export type Editing = ReturnType<typeof createEditing>;

/**
 * @param editor a dedicated editor
 * @param from throws if it is invalid
 */
export function createEditing(editor: Editor, from: History = EMPTY_HISTORY) {
  const loaded = editor.load({ version: VERSION, history: from });
  return editingOf(editor, loaded, loaded.dropped.length > 0 ? editor.save() : from);
}

/**
 * Opens a history out of the database or of the journal. Throws `damaged-project` or `newer-project`.
 * @param editor a dedicated editor
 */
export function openEditing(editor: Editor, record: KeptHistory) {
  const loaded = editor.load(record);
  return editingOf(editor, loaded, editor.save());
}

function editingOf(editor: Editor, { dropped, ...ids }: Loaded, from: History) {
  let history = from;
  let { pageId, sheet } = ids;

  return {
    /** Sentences about the parts that could not be read. */
    dropped,
    history: () => history,
    /**
     * @param photos in use
     * @returns the page that an intent would make the current page; null if the page stays
     */
    preview: (intent: Intent, photos: readonly PhotoMeta[]) => editor.preview(jsonOf(intent), photos),
    obstacles: editor.obstacles,
    /** Plans pages of the present from photos in use. */
    plans: editor.plans,
    /** Ids that were never used, nor any above them: of a page, and of a place in the storyboard. */
    fresh: () => ({ pageId, sheet }),
    /**
     * Throws `invalid-document`, and for intents the errors of the planner. Then nothing changed.
     * @param photos in use, for intents
     * @returns the same object when nothing changed
     */
    apply: (change: Change, photos?: readonly PhotoMeta[]): History => {
      const told = editor.apply(jsonOf(withoutKnown(change, history)), photos);
      ({ pageId, sheet } = told);
      history = laidOver(history, told, pagesIn(change));
      return history;
    },
  };
}

/** Replaces lone surrogates, which the user can paste and the core rejects. */
function jsonOf(edit: object): string {
  const text = JSON.stringify(edit);
  if (!text.includes('\\ud')) return text;
  return JSON.stringify(edit, (_, value) => (typeof value === 'string' ? wellFormed(value) : value));
}

/** @returns with only the ids of pages that the core already has */
function withoutKnown(change: Change, { present, shown }: History): object {
  const pages = new Map([...shown.map(({ id, page }) => [id, page] as const), ...ownPages(present)]);
  const spared = <T extends { page: PageDocument; pageId: number }>(one: T) =>
    pages.get(one.pageId) === one.page ? { ...one, page: undefined } : one;
  if (change.type === 'show-page') return spared(change);
  if (change.type === 'set-sheets') return { ...change, sheets: change.sheets.map(spared) };
  return change;
}

function ownPages(project: Project) {
  // If two have the same id, the core uses the first.
  return sheetsOf(project)
    .map(({ pageId, page }) => [pageId, page] as const)
    .toReversed();
}

/** The core returns most pages unchanged. Then the object identity of a page is preserved. */
function pagesIn(change: Change): readonly PageDocument[] {
  if (change.type === 'set-sheets') return change.sheets.map(({ page }) => page);
  return 'page' in change && change.page ? [change.page] : [];
}

function laidOver(was: History, told: Difference, given: readonly PageDocument[]): History {
  const before = [...was.past, was.present, ...was.future];
  const { state, withPage } = joinedWith(withGiven(told.parts, given), knownParts(was));
  const states: Project[] = [
    ...before,
    ...told.states.map(([of, fields]) => bare({ ...before[of], ...state(fields) })),
  ];
  const entries: Shown[] = [...was.shown, ...told.entries.map(withPage)];
  const now = {
    past: listed(told.past, states, was.past),
    present: states[told.present],
    future: listed(told.future, states, was.future),
    shown: listed(told.shown, entries, was.shown),
  };
  return Object.entries(now).every(([part, value]) => was[part as keyof History] === value) ? was : now;
}

/** Removes empty unplaced text and default storyboard settings. */
function bare(project: Project): Project {
  const { waiting, board, ...rest } = project;
  if (waiting?.length !== 0 && board !== null) return project;
  return { ...rest, ...(waiting?.length ? { waiting } : {}), ...(board ? { board } : {}) };
}

function withGiven(parts: Difference['parts'], given: readonly PageDocument[]): Difference['parts'] {
  if (parts.pages.length === 0) return parts;
  const texts = new Map(given.map((page) => [JSON.stringify(page), page]));
  return { ...parts, pages: parts.pages.map((page) => texts.get(JSON.stringify(page)) ?? page) };
}

/** In the order in which the core counts them (`knowing` in `crates/model/src/kept.rs`). */
function knownParts({ present, shown }: History): Known {
  const { tray, page, others, mine, favourites, ownLayouts, settings, draft, waiting = [], board } = present;
  return {
    items: tray,
    pages: [...(page ? [page] : []), ...[...others, ...shown].map((one) => one.page)],
    sheets: others,
    styles: [...mine, ...favourites],
    layouts: ownLayouts,
    settings: [settings],
    drafts: draft ? [draft] : [],
    words: waiting,
    // The core omits default settings, but counts them.
    boards: [board as Board],
  };
}

/** @returns the old list if nothing changed */
function listed<T>(runs: Runs, all: readonly T[], before: readonly T[]): readonly T[] {
  const list = runs.flatMap(([first, count]) => all.slice(first, first + count));
  return list.length === before.length && list.every((one, i) => one === before[i]) ? before : list;
}
