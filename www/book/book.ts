/**
 * A storyboard of several pages: pages added, spread over, turned, moved, removed. Each is one undo step, except going
 * to another page, which changes nothing. An undo goes to the page that it changes.
 */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { noteUntilUndo } from '../ui/undo-note.ts';
import { photosOn, sheetsOf } from '../engine/sheets.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Messages, Way } from '../ui/messages.ts';
import type { Pages } from '../document/pages.ts';
import type { Sheet } from '../engine/sheets.ts';
import type { Store } from '../document/store.ts';

/** Minimum number of photos on no page for an offer to make more pages. */
const MANY_LEFT = 4;

export type Book = ReturnType<typeof createBook>;

export function createBook({
  store,
  pages,
  messages,
  onKept = () => {},
}: {
  store: Store;
  pages: Pick<Pages, 'add' | 'spread'>;
  messages: Pick<Messages, 'list' | 'note' | 'close'>;
  /** Called with the page before another is added. */
  onKept?: (page: PageDocument) => void;
}) {
  /** The photos in use that no page shows. */
  const left = computed(() => {
    const shown = photosOn(store.sheets.value);
    return store.photos.value.filter(({ id }) => !shown.has(id));
  });
  /** Whether all pages have the style of this one. */
  const oneStyle = computed(() => new Set(store.sheets.value.map(({ style }) => JSON.stringify(style))).size <= 1);

  const at = computed(() => store.project.value.at);
  const several = computed(() => store.project.value.others.length > 0);

  /** Whether the pages are a book with a cover. */
  const isMade = computed(() => several.value && store.sheets.value.some((page) => isCover(page)));

  /** Names the page that is edited through all its versions. */
  const sheet = computed(() => store.project.value.sheet);

  return {
    left,
    /** Whether enough photos are on no page for an offer to make more pages. */
    areManyLeft: computed(() => left.value.length >= MANY_LEFT),
    oneStyle,
    isMade,
    coverAt,
    hasDays: computed(() => new Set(store.photos.value.map(({ taken }) => taken?.slice(0, 10))).size > 1),
    at,
    several,
    sheet,
    cannotAdd,
    cannotSpread,
    go,
    step,
    add,
    remove,
    move,
    spreadAlbum,
    replace,
    styleAll,
  };

  /** @returns the place of the cover, or -1 */
  function coverAt(): number {
    return store.sheets.value.findIndex(isCover);
  }

  /** @returns why there can be no more pages now; empty when there can */
  function cannotAdd(): string {
    if (store.reading.value) return strings.book.reading;
    return store.page.value ? '' : strings.noPhotosInUse;
  }

  /** @returns why the album cannot be spread; empty when it can */
  function cannotSpread(): string {
    return cannotAdd() || (store.project.value.locks.photos ? strings.locked.photos : '');
  }

  /**
   * Turns to a page.
   * @param at its place, from 0
   */
  function go(at: number) {
    if (at >= 0) store.change({ type: 'go-to-page', at, silent: true });
  }

  /** Turns some pages on or back. */
  function step(by: number) {
    go(store.project.peek().at + by);
  }

  /** Inserts a page after this one in the same style, with photos that no page shows, if there are any. */
  function add() {
    const { page, at } = store.project.peek();
    if (!page || cannotAdd() !== '') return;
    const elsewhere = photosOn(store.sheets.peek());
    if (!pages.add()) return;
    onKept(page);
    const repeated = [...photosOn(store.sheets.peek().slice(at + 1, at + 2))].filter((photo) =>
      elsewhere.has(photo),
    ).length;
    if (repeated > 0) noteUntilUndo({ messages, store }, strings.book.repeats({ n: repeated }));
  }

  /** Takes this page out of the storyboard; its photos are free for the others. */
  function remove() {
    const { at, others } = store.project.peek();
    if (others.length === 0) return;
    const sheets = sheetsOf(store.project.peek());
    store.change({ type: 'remove-page' });
    noteUntilUndo({ messages, store }, strings.book.removed({ n: at + 1 }), {
      label: strings.bringBack,
      run: () => {
        const now = sheetsOf(store.project.peek());
        if (now.every(({ sheet }) => sheet !== sheets[at].sheet))
          bringBack(now.toSpliced(at, 0, sheets[at]), Math.min(at, now.length));
      },
    });
  }

  /** Restores earlier pages. This is not an undo, which would also revert later edits. */
  function bringBack(sheets: readonly Sheet[], at: number) {
    const album = store.album.peek();
    // Another project may be open by now.
    if ([...photosOn(sheets.map(({ page }) => page))].every((photo) => album.has(photo))) set(sheets, at);
  }

  /**
   * The edited page does not change.
   * @param to its index after removal
   */
  function move(from: number, to: number) {
    if (from >= 0 && to >= 0) store.change({ type: 'move-page', from, to });
  }

  /** Distributes all photos in use over as many pages as needed, replacing the present pages. */
  function spreadAlbum() {
    const project = store.project.peek();
    const before = sheetsOf(project);
    if (!project.page || cannotSpread() !== '') return;
    if (!pages.spread()) return;
    const text = strings.book.spread({ photos: store.photos.peek().length, pages: store.sheets.peek().length });
    offerBack({ text, before, at: project.at });
  }

  /** Replaces all pages, and offers to restore the pages `before`. `more`: another offer. */
  function replace(
    sheets: readonly Sheet[],
    offer: { text: string; before: readonly Sheet[]; at: number; more?: Way },
  ) {
    set(sheets, 0);
    offerBack(offer);
  }

  function offerBack({ text, before, at, more }: { text: string; before: readonly Sheet[]; at: number; more?: Way }) {
    const back = { label: strings.book.takeBack, run: () => bringBack(before, at) };
    noteUntilUndo({ messages, store }, text, back, more);
  }

  /** Gives all pages the style of this one. */
  function styleAll() {
    store.change({ type: 'style-pages' });
  }

  function set(sheets: readonly Sheet[], at: number) {
    store.change({ type: 'set-sheets', sheets, at });
  }
}

/** Whether a page has text of a book, but no page number: it is the cover. */
function isCover({ words = [] }: PageDocument): boolean {
  return words.some(({ book }) => book) && !words.some(({ number }) => number);
}
