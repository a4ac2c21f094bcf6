// @ts-check
/**
 * Which photos are used and in which order: how alike two may be, which of a stack, by time or by name. The page
 * shows the answer at once, and each change is one step of the undo.
 */

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('./project.js').Order} Order */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {ReturnType<typeof createChoosing>} Choosing */

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

/**
 * @param {{ store: Store, pages: Pages, reading: import('./reading.js').Reading }} app
 */
export function createChoosing({ store, pages, reading }) {
  return { setAlike, setOrder, take };

  /**
   * @param {number} alike bits of a fingerprint, 4 to 16
   */
  function setAlike(alike) {
    const before = store.photos.peek().length;
    reading.edit({ type: 'choose-by', alike }, () => pages.refit({ grow: store.photos.peek().length > before }), 'alike');
  }

  /** @param {Order} order */
  function setOrder(order) {
    reading.edit({ type: 'choose-by', order }, () => {
      const { page, locks } = store.project.peek();
      return page && !locks.photos ? replanned(resorted(page, store.photos.peek().map(({ id }) => id))) : undefined;
    });
  }

  /**
   * Takes one photo in place of those that look like it, on the page too.
   * @param {string} id
   * @param {readonly string[]} alike the whole stack
   */
  function take(id, alike) {
    const uses = new Map(alike.map((other) => [other, other === id]));
    reading.edit({ type: 'use-photos', uses }, () => {
      const { page } = store.project.peek();
      return page && replanned(exchanged(page, id, alike));
    });
  }

  /** @param {PageDocument} page */
  function replanned(page) {
    return pages.plan({ keep: KEEP_ALL, current: page, seed: page.seed });
  }
}

/**
 * The page with one photo wherever it shows another of a stack, but in locked panels.
 * @param {PageDocument} page
 * @param {string} id
 * @param {readonly string[]} alike
 * @returns {PageDocument}
 */
export function exchanged(page, id, alike) {
  const swap = (/** @type {string} */ photo) => (alike.includes(photo) ? id : photo);
  const panels = page.panels.map((panel) => (
    panel.locked || panel.photo === null || !alike.includes(panel.photo) ? panel : { ...panel, photo: id, crop: null, edited: false }
  ));
  return { ...page, panels, order: [...new Set(page.order.map(swap))] };
}

/**
 * The page with the same photos in another order, locked panels apart.
 * @param {PageDocument} page
 * @param {readonly string[]} ids all photos in use, in that order
 * @returns {PageDocument}
 */
export function resorted(page, ids) {
  const rank = (/** @type {string | null} */ id) => (id === null ? Infinity : ids.indexOf(id));
  const leader = (/** @type {number} */ i) => page.merges.find((group) => group.includes(i))?.[0] ?? i;
  const free = page.panels.map((_, i) => i).filter((i) => leader(i) === i && !page.panels[i].locked);
  const photos = free.map((i) => page.panels[i].photo).sort((a, b) => rank(a) - rank(b));
  const panels = page.panels.map((panel, i) => {
    const at = free.indexOf(leader(i));
    if (at < 0 || photos[at] === panel.photo) return panel;
    return { ...panel, photo: photos[at], crop: null, edited: false };
  });
  return { ...page, panels, order: [...page.order].sort((a, b) => rank(a) - rank(b)) };
}
