/**
 * The editor of a project. The core applies edits, and this module has a readable copy of the present and the page
 * history. Unchanged parts keep their object identity, so drawing and caches can skip them. It also has the changes since
 * the last saving, for the journal and for an editor that broke.
 */

import { bytesOf, joinedWith } from '../engine/interned.ts';
import { VERSION } from '../engine/versions.ts';
import { EMPTY_MIRROR } from './history.ts';
import { wellFormed } from './limits.ts';
import { sheetsOf } from '../engine/sheets.ts';
import type { Editor } from '../engine/core.ts';
import type { Known } from '../engine/interned.ts';
import type { Board, Difference, Intent, PhotoMeta, Runs } from '../engine/types.ts';
import type { Beginning, Change, Mirror, Shown } from './history.ts';
import type { PageDocument, Project } from './project.ts';

export type Editing = ReturnType<typeof openEditing>;
/** The bytes of a history, and the number of changes before. */
export type Saved = { bytes: Uint8Array<ArrayBuffer>; at: number };

/** A change without edits, which ends a gesture. */
const END = '[]';

/** The number of undo steps of all editors. */
let steps = 0;

/**
 * @param editor a dedicated editor
 * @param from throws if it is invalid
 */
export function createEditing(editor: Editor, { present, shown }: Beginning = EMPTY_MIRROR): Editing {
  return openEditing(editor, bytesOf({ version: VERSION, history: { past: [], present, future: [], shown } }));
}

/**
 * Opens a history out of the database. Throws `damaged-project` or `newer-project`, and `invalid-document` for the
 * journal.
 * @param editor a dedicated editor
 * @param journal changes that were made since, each as the text of a list of edits
 */
export function openEditing(editor: Editor, bytes: Uint8Array<ArrayBuffer>, journal: readonly string[] = []) {
  let core = editor;
  let told = core.load(bytes, textOf(journal));
  let mirror = begun(told);
  /** Changes since the last saving. The first has the number `first`. After loading, a gesture does not go on. */
  const changes = [...journal, END];
  let first = 0;
  let saved: Saved = { bytes, at: 0 };
  let isCurrent = false;

  return {
    /** Sentences about the parts that could not be read. */
    dropped: told.dropped,
    mirror: () => mirror,
    /**
     * @param photos in use
     * @returns the page that an intent would make the current page; null if the page stays
     */
    preview: (intent: Intent, photos: readonly PhotoMeta[]) => core.preview(jsonOf(intent), photos),
    obstacles: (panels: readonly number[]) => core.obstacles(panels),
    /** Plans pages of the present from photos in use. */
    plans: (photos: readonly PhotoMeta[]) => core.plans(photos),
    /** The ids of all photos of the history. */
    photos: () => core.photos(),
    /** Ids that were never used, nor any above them: of a page, and of a place in the storyboard. */
    fresh: () => ({ pageId: told.pageId, sheet: told.sheet }),
    apply,
    save,
    /** @returns changes from a number on, each as the text of a list of edits; null if they were removed */
    since: (at: number): readonly string[] | null => (at < first ? null : changes.slice(at - first)),
    /** Removes changes before a number, which is saved. */
    trim: (at: number) => {
      const removed = changes.splice(0, Math.min(at, saved.at) - first);
      first += removed.length;
    },
    /** Continues with another editor, because this one broke. */
    revive: (fresh: Editor) => {
      told = fresh.load(saved.bytes, textOf(changes.slice(saved.at - first)));
      core = fresh;
      mirror = begun(told);
      changes.push(END);
    },
  };

  /**
   * Throws `invalid-document`, and for intents the errors of the planner. Then nothing changed.
   * @param photos in use, for intents
   * @returns the same object when nothing changed
   */
  function apply(change: Change, photos?: readonly PhotoMeta[]): Mirror {
    told = core.apply(jsonOf(withoutKnown(change, mirror)), photos);
    const { changed, includes } = told;
    if (!changed) return mirror;
    const before = mirror;
    const { now, edits } = laidOver(before, told, pagesIn(change));
    mirror = now;
    // Before the changes that this one includes, the core had other pages.
    const texts = (edits.length > 0 ? edits : [change]).map((edit) =>
      jsonOf(includes > 0 ? edit : withoutKnown(edit, before)),
    );
    changes.splice(changes.length - includes, includes, `[${texts.join()}]`);
    return mirror;
  }

  function count() {
    return first + changes.length;
  }

  function save(): Saved {
    if (!isCurrent || saved.at !== count()) saved = { bytes: core.save(), at: count() };
    isCurrent = true;
    return saved;
  }
}

/** The copy of a history that was loaded. */
function begun(told: Difference): Mirror {
  steps += 1;
  return { ...laidOver(EMPTY_MIRROR, told, []).now, step: steps };
}

function textOf(changes: readonly string[]) {
  return changes.length > 0 ? `[${changes.join()}]` : '';
}

/** Replaces lone surrogates, which the user can paste and the core rejects. */
function jsonOf(edit: object): string {
  const text = JSON.stringify(edit);
  if (!text.includes('\\ud')) return text;
  return JSON.stringify(edit, (_, value) => (typeof value === 'string' ? wellFormed(value) : value));
}

/** @returns with only the ids of pages that the core already has */
function withoutKnown(change: Change, { present, shown }: Mirror): object {
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

/** @returns the copy after a change, and the edits that an intent led to */
function laidOver(was: Mirror, told: Difference, given: readonly PageDocument[]): { now: Mirror; edits: Change[] } {
  const { state, withPage, edit } = joinedWith(withGiven(told.parts, given), knownParts(was));
  const fields = state(told.present);
  if (told.stepped) steps += 1;
  const now = {
    present: Object.keys(fields).length > 0 ? bare({ ...was.present, ...fields }) : was.present,
    shown: listed(told.shown, [...was.shown, ...told.entries.map(withPage)], was.shown),
    undos: told.undos,
    redos: told.redos,
    step: told.stepped ? steps : was.step,
  };
  return { now, edits: told.edits.map(edit) };
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
function knownParts({ present, shown }: Mirror): Known {
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
function listed(runs: Runs, all: readonly Shown[], before: readonly Shown[]): readonly Shown[] {
  const list = runs.flatMap(([first, count]) => all.slice(first, first + count));
  return list.length === before.length && list.every((one, i) => one === before[i]) ? before : list;
}
