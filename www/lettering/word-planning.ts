/**
 * Text items during planning: loads the glyphs when a page first has text, and places all items that the user did not
 * move.
 */

import { computed, effect, signal, untracked } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { MOST } from '../document/limits.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { explain } from '../ui/explain.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { How, PageDocument, Word, WordBox } from '../engine/types.ts';
import type { KnownPhoto, Lettering as Letters } from '../engine/words.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

/** Minimum time in ms without a drag before the alternatives show the new text. */
const DELAY = 300;

/** @param app `load`: loads the glyphs */
export function createWordPlanning({
  store,
  messages,
  load,
  scheduler,
}: {
  store: Store;
  messages: Pick<Messages, 'alert'>;
  load: () => Promise<Letters>;
  scheduler: Pick<Scheduler, 'background'>;
}) {
  const letters: Signal<Letters | null> = signal(null);
  const loading = signal(false);
  const none = [] as readonly Word[];
  const words = computed(() => store.page.value?.words ?? none);
  /** The text items after the last change. */
  const rested = signal(none);
  /**
   * Pages that were planned before the glyphs were loaded: their text items still have the positions of another page. One of
   * them may be the page now, or none, as pages are also planned ahead.
   */
  const owed: Set<string> = new Set();

  let stop = new AbortController();
  effect(() => {
    const now = words.value;
    stop.abort();
    if (essence(now) === essence(rested.peek())) return;
    stop = new AbortController();
    const show = () => {
      rested.value = now;
    };
    scheduler.background(show, { delay: DELAY, signal: stop.signal });
  });
  // A page that is opened with text, from a file or an earlier session, needs the glyphs too. Its text items do not
  // move, even if detection has found more.
  effect(() => {
    if (words.value.length > 0 && !letters.value) void ready().then((table) => table && settleOwed());
  });
  // Text items that came with a photo, or that were added to all pages, have no position yet. Placing them is not a
  // separate undo step.
  effect(() => {
    const project = store.project.value;
    const lost = sheetsOf(project).some(({ page }) => homeless(page).length > 0);
    if (!lost) return;
    if (!letters.value) {
      if (words.peek().length === 0) void ready();
      return;
    }
    untracked(() => {
      const pages = sheetsOf(project).flatMap(({ page }, at) => {
        const some = homeless(page);
        return some.length > 0 ? [{ at, page: settled(page, some) }] : [];
      });
      if (!pages.some(({ page }) => homeless(page).length > 0)) setWords(store, pages, { silent: true });
    });
  });

  return { words, letters, loading: loading as ReadonlySignal<boolean>, rested, ready, settled, cleared, stayed, on };

  /** @returns null if the glyphs cannot be loaded, which is reported */
  async function ready(): Promise<Letters | null> {
    if (letters.peek()) return letters.peek();
    loading.value = true;
    try {
      letters.value = await load();
      return letters.peek();
    } catch (error) {
      messages.alert(strings.wordsFailed({ why: explain(error) }));
      return null;
    } finally {
      loading.value = false;
    }
  }

  /**
   * Places the text items of a page clear of faces, and of subjects as far as possible. If the layout has changed, text
   * items that the user placed move off faces as well. If only the style has changed, no item moves.
   * @param only the text items that may move; by default all
   * @param before the earlier page in its place; by default the current page
   */
  function settled(
    page: PageDocument,
    only?: readonly number[],
    before: PageDocument | null = store.page.peek(),
  ): PageDocument {
    const table = letters.peek();
    const all = page.words ?? [];
    const stays = (i: number) => only !== undefined && !only.includes(i);
    const again = only === undefined && isLaidOut(page, before);
    if (!again && !all.some(({ auto }, i) => auto !== false && !stays(i))) return page;
    if (all.length === 0 || (only === undefined && isRestyled(page, before))) return page;
    if (!table) {
      owed.add(keyOf(page));
      return page;
    }
    const fixed = all.map((word, i) => (stays(i) ? { ...word, auto: false } : word));
    const placed = table.settle({ ...page, words: fixed }, knownOn(page), again);
    return { ...page, words: all.map((word, i) => (stays(i) ? word : placed[i])) };
  }

  /**
   * Returns a page with an automatic text item at its earlier place after its text changed. Null if it does not fit there, or
   * without glyphs.
   * @param before its earlier bounds
   * @param isAlone whether it may move to the closest place without a face
   */
  function stayed(page: PageDocument, index: number, before: WordBox, isAlone: boolean): PageDocument | null {
    const words = letters.peek()?.stay(page, knownOn(page), index, before);
    if (words) return { ...page, words };
    if (!isAlone || page.words?.[index].auto === false) return null;
    // Its earlier room may be too small for its text.
    const roomless = (page.words ?? []).map((word, i) => (i === index ? { ...word, room: undefined } : word));
    return offFaces({ ...page, words: roomless }, [index]);
  }

  /**
   * Returns a page whose photos were analysed again: automatic text that the user did not write is placed again, and text of
   * the user moves only if it covers a face. A page that is opened again is unchanged.
   */
  function cleared(page: PageDocument): PageDocument {
    const words = page.words ?? [];
    const free = [...words.keys()].filter((i) => words[i].auto !== false);
    const isOwn = (i: number) => !words[i].made && words[i].cue === undefined;
    const others = free.filter((i) => !isOwn(i));
    const placed = others.length > 0 ? settled(page, others) : page;
    return free.some(isOwn) ? (offFaces(placed, free.filter(isOwn)) ?? placed) : placed;
  }

  /**
   * Returns a page whose automatic text items moved off faces, by the rule for fixed text. Others stay. Null without glyphs.
   */
  function offFaces(page: PageDocument, only: readonly number[]): PageDocument | null {
    const all = page.words ?? [];
    const fixed = all.map((word) => ({ ...word, auto: false }));
    const words = letters.peek()?.settle({ ...page, words: fixed }, knownOn(page), true);
    if (!words) return null;
    return { ...page, words: all.map((word, i) => (only.includes(i) ? { ...words[i], auto: word.auto } : word)) };
  }

  /** The subjects and masks of the photos of a page, by their ids. */
  function knownOn({ panels }: PageDocument): Record<string, KnownPhoto> {
    const [album, masks] = [store.album.peek(), store.masks.peek()];
    return Object.fromEntries(
      panels.flatMap(({ photo }) => {
        const meta = photo === null ? undefined : album.get(photo)?.meta;
        return photo !== null && meta ? [[photo, { subjects: meta.subjects, mask: masks.get(photo) }]] : [];
      }),
    );
  }

  /**
   * Returns another page with the text items of this page whose photos it shows, and the unplaced text of its photos,
   * up to the limit of a page. Text without a photo stays unplaced.
   */
  function on(page: PageDocument): PageDocument {
    const { waiting = [] } = store.project.peek();
    const unplaced = waiting.filter(({ photo }) => photo);
    const own = [...words.peek(), ...unplaced].flatMap((word) => carried(word, page)).slice(0, MOST.words);
    return !page.words?.length && own.length === 0 ? page : settled({ ...page, words: own });
  }

  function settleOwed() {
    const page = store.page.peek();
    const next = page && owed.has(keyOf(page)) ? settled(page) : null;
    owed.clear();
    if (next && JSON.stringify(next.words) !== JSON.stringify(page?.words))
      setWords(store, [{ at: store.project.peek().at, page: next }], { silent: true });
  }
}

/** Tells pages with text apart, also after the core stored them. */
function keyOf({ layout, panels, words = [] }: PageDocument): string {
  const id = typeof layout === 'string' ? layout : layout.id;
  return JSON.stringify([id, panels.map(({ photo }) => photo), words.map(({ text, panel }) => [text, panel])]);
}

/** Gives pages the text items of other versions of them. */
export function setWords(
  store: Pick<Store, 'change'>,
  pages: readonly { at: number; page: PageDocument }[],
  how: How = {},
) {
  store.change({ type: 'set-words', pages: pages.map(({ at, page }) => ({ at, words: page.words ?? [] })), ...how });
}

/** Returns whether a page shows other parts of its photos than the page before, or shows them elsewhere. */
function isLaidOut(page: PageDocument, before: PageDocument | null): boolean {
  const look = ({ layout, page: { width, height, gutter, margin }, panels, merges }: PageDocument) =>
    JSON.stringify([layout, width / height, gutter, margin, merges, panels.map(({ photo, crop }) => [photo, crop])]);
  return before !== null && look(page) !== look(before);
}

/** Whether a page only has another style, and maybe its paper. The text items keep their places and their speakers. */
function isRestyled(page: PageDocument, before: PageDocument | null): boolean {
  const rest = ({ style, seed, page: { paper, borderColor, ...settings }, ...others }: PageDocument) =>
    JSON.stringify([settings, others]);
  return before !== null && before !== page && homeless(page).length === 0 && rest(page) === rest(before);
}

/** Returns the text items of a page without a position. */
function homeless({ words = [] }: PageDocument): number[] {
  return words.flatMap(({ auto, x }, i) => (auto !== false && (x === undefined || x === null) ? [i] : []));
}

/** The text item on the panel of its photo, as in the core; empty if the page does not show the photo. */
function carried(word: Word, { panels }: PageDocument): Word[] {
  const { photo, panel } = word;
  if (!photo || panel === undefined || panel === null || panels[panel]?.photo === photo) return [word];
  const at = panels.findIndex((other) => other.photo === photo);
  return at < 0 ? [] : [{ ...word, panel: at }];
}

/** @returns everything except automatic positions */
function essence(words: readonly Word[]): string {
  return JSON.stringify(words.map((word) => (word.auto ? { ...word, x: 0, y: 0, tail: null } : word)));
}
