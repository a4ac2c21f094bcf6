// @ts-check
/** The pages shown so far, as a person looks through them: which came from which, and which are favourites. */

import { computed } from '@preact/signals';
import { position } from './history.js';

/** @typedef {import('./project.js').PageDocument} PageDocument */
/** @typedef {{ id: number, number: number, page: PageDocument, from: number | null, loved: boolean, current: boolean }} Entry `from`: the number of the page it was made from, where that is not the one before it */
/** @typedef {ReturnType<typeof createShownPages>} ShownPages */

/** @param {{ store: import('./store.js').Store }} app */
export function createShownPages({ store }) {
  const entries = computed(() => {
    const { history } = store;
    const { shown, present } = history.value;
    const numbers = new Map(shown.map(({ id }, i) => [id, i + 1]));
    return shown.map(({ id, page, from }, i) => {
      const number = from === undefined ? null : numbers.get(from) ?? null;
      return { id, number: i + 1, page, from: number === i ? null : number, loved: present.loved.includes(id), current: present.page !== null && id === present.pageId };
    });
  });

  return { entries, go, love, loved: computed(() => store.project.value.loved.includes(store.project.value.pageId)), loveThis };

  /** Goes back to a page; a shuffle from there begins another branch. @param {number} id */
  function go(id) {
    const { shown } = store.history.peek();
    const target = shown.find((entry) => entry.id === id);
    if (target && shown[position(store.history.peek())] !== target) store.change({ type: 'show-page', page: target.page, pageId: id });
  }

  /** @param {number} id @param {boolean} on */
  function love(id, on) {
    store.change({ type: 'love-page', pageId: id, on });
  }

  /** Makes the page a favourite, or no longer. */
  function loveThis() {
    const { pageId, loved } = store.project.peek();
    if (store.page.peek()) love(pageId, !loved.includes(pageId));
  }
}
