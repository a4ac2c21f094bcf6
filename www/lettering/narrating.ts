/** The title and captions of new pages, and the setting that turns them off. */

import { narrated as withNarration, plain } from './narration.ts';
import { setWords } from './word-planning.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { strings, language } from '../strings/strings.ts';
import type { Ui } from '../ui/ui.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Moment } from './narration.ts';

export type Narrating = ReturnType<typeof createNarrating>;

/**
 * @param app `album`: the title of the album, and when and where its photos were taken; `placed` marks text with place names.
 * `settled` places text. `cleared` places the text of a page again after its photos were analysed
 */
export function createNarrating({
  store,
  ui,
  album,
  placed = (page) => page,
  settled,
  cleared,
}: {
  store: Store;
  ui: Pick<Ui, 'narrates' | 'narrate' | 'showPlaces'>;
  album: { title: () => string; moments: () => Map<string, Moment> };
  placed?: (page: PageDocument) => PageDocument;
  settled: (page: PageDocument, only: readonly number[]) => PageDocument;
  cleared: (page: PageDocument) => PageDocument;
}) {
  return { narrated, turn, turnPlaces, avoidFaces, renew };

  /** @param page a new page at `at` among the pages; only the first has a title */
  function narrated(page: PageDocument, at: number): PageDocument {
    if (!ui.narrates.peek()) return plain(page);
    return placed(
      withNarration(page, {
        title: at === 0 ? album.title() : '',
        moments: album.moments(),
        language,
        day: strings.dayOf,
        time: strings.timeOf,
      }),
    );
  }

  /** Moves text off faces that were detected after it was placed. Text that the user moved stays. */
  function avoidFaces() {
    const page = store.page.peek();
    if (!page) return;
    const moved = cleared(page);
    if (JSON.stringify(moved.words) !== JSON.stringify(page.words))
      setWords(store, [{ at: store.project.peek().at, page: moved }], { silent: true });
  }

  /** Tells the places that became known after the first page was planned, if the user has changed nothing yet. */
  function renew() {
    const { page, at } = store.project.peek();
    if (!page || !ui.narrates.peek() || store.canUndo.peek()) return;
    if ((plain(page).words ?? []).length > 0) return;
    const next = narrated(page, at);
    const moved = settled(next, [...(next.words ?? []).keys()]);
    if (JSON.stringify(textsOf(moved)) !== JSON.stringify(textsOf(page)))
      setWords(store, [{ at: store.project.peek().at, page: moved }], { silent: true });
  }

  /** Turns title and captions on or off, for the shown page at once. */
  function turn(on: boolean) {
    ui.narrate(on);
    const { page, at } = store.project.peek();
    if (page) setWords(store, [{ at, page: narrated(page, at) }]);
  }

  /** Turns place names on or off, in the captions of all pages at once. A book keeps its text until it is made again. */
  function turnPlaces(on: boolean) {
    ui.showPlaces(on);
    const pages = sheetsOf(store.project.peek()).flatMap(({ page }, at) => {
      const words = page.words ?? [];
      if (!words.some(({ made, book }) => made && !book)) return [];
      // A page with text of the user gets no new captions.
      const next = (plain(page).words ?? []).length === 0 ? narrated(page, at) : unlocated(page);
      const isSame = JSON.stringify(textsOf(next)) === JSON.stringify(textsOf(page));
      return isSame ? [] : [{ at, page: settled(next, [...(next.words ?? []).keys()]) }];
    });
    if (pages.length > 0) setWords(store, pages);
  }
}

/** Returns the page without captions that name places, except the text of a book. */
function unlocated(page: PageDocument): PageDocument {
  return { ...page, words: page.words?.filter(({ located, book }) => !located || book) };
}

function textsOf({ words = [] }: PageDocument): string[] {
  return words.map(({ text }) => text);
}
