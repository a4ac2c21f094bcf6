/** The title and captions of new pages, and the setting that turns them off. */

import { narrated as withNarration, plain } from './narration.ts';
import { strings, language } from '../strings/strings.ts';
import type { Ui } from '../app/ui.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Moment } from './narration.ts';

export type Narrating = ReturnType<typeof createNarrating>;

/** @param app `album`: the title of the album, and when and where its photos were taken */
export function createNarrating({
  store,
  ui,
  album,
}: {
  store: Store;
  ui: Pick<Ui, 'narrates' | 'narrate'>;
  album: { title: () => string; moments: () => Map<string, Moment> };
}) {
  return { narrated, turn };

  /** @param page a new page at `at` among the pages; only the first has a title */
  function narrated(page: PageDocument, at: number): PageDocument {
    if (!ui.narrates.peek()) return plain(page);
    return withNarration(page, {
      title: at === 0 ? album.title() : '',
      moments: album.moments(),
      language,
      day: strings.dayOf,
      time: strings.timeOf,
    });
  }

  /** Turns title and captions on or off, for the shown page at once. */
  function turn(on: boolean) {
    ui.narrate(on);
    const { page, at } = store.project.peek();
    if (page) store.change({ type: 'change-page', page: narrated(page, at) });
  }
}
