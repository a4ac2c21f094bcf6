/** The page history as the user sees it: the origin of each page, and favourites. */

import { computed, signal } from '@preact/signals';
import { sheetsOf } from '../engine/sheets.ts';
import type { Pages } from '../document/pages.ts';
import type { PageDocument } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Signal } from '@preact/signals';

/**
 * `from`: number of the page that it was made from, if it is not the one before. `place`: the page of the storyboard
 * whose version it is; null if the storyboard has only one page, or the page was removed.
 */
export type Entry = {
  id: number;
  number: number;
  page: PageDocument;
  from: number | null;
  place: number | null;
  loved: boolean;
  current: boolean;
};
export type ShownPages = ReturnType<typeof createShownPages>;

export function createShownPages({
  store,
  pages,
  onLoved = () => {},
}: {
  store: Store;
  pages: Pick<Pages, 'bringBack'>;
  onLoved?: (page: PageDocument) => void;
}) {
  const entries = computed(() => {
    const [shown, present] = [store.pageHistory.value, store.project.value];
    const numbers = new Map(shown.map(({ id }, i) => [id, i + 1]));
    const places = new Map(sheetsOf(present).map(({ sheet }, i) => [sheet, i + 1]));
    return shown.map(({ id, page, from, sheet = 0 }, i) => {
      const place = places.size > 1 ? (places.get(sheet) ?? null) : null;
      const number = from === undefined ? null : (numbers.get(from) ?? null);
      return {
        id,
        number: i + 1,
        page,
        from: number === i ? null : number,
        place,
        loved: present.loved.includes(id),
        current: present.page !== null && id === present.pageId,
      };
    });
  });

  return {
    entries,
    /** The versions that are compared, at most two. */
    pair: signal([]) as Signal<readonly number[]>,
    go,
    love,
    loved: computed(() => store.project.value.loved.includes(store.project.value.pageId)),
    loveThis,
  };

  /** Goes back to a page; a shuffle from there begins another branch. */
  function go(id: number) {
    const target = store.pageHistory.peek().find((entry) => entry.id === id);
    if (target && (store.page.peek() === null || id !== store.project.peek().pageId)) pages.bringBack(target);
  }

  function love(id: number, on: boolean) {
    store.change({ type: 'love-page', pageId: id, on });
    const entry = on ? store.pageHistory.peek().find((other) => other.id === id) : undefined;
    if (entry) onLoved(entry.page);
  }

  /** Makes the page a favourite, or no longer. */
  function loveThis() {
    const { pageId, loved } = store.project.peek();
    if (store.page.peek()) love(pageId, !loved.includes(pageId));
  }
}
