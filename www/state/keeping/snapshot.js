// @ts-check
/** What of the session is kept: the document with its history, and of the photos all that any of its states needs. */

/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Video} Video */
/** @typedef {import('../history.js').History} History */
/** @typedef {import('../place.js').Place} Place */
/** @typedef {import('../project.js').Project} Project */
/** `place` is where this history is kept, and no other. @typedef {{ place: Place, history: import('./database.js').KeptHistory, drawn: readonly Project[], facts: Fact[], videos: Video[] }} Snapshot */

/**
 * @param {import('../store.js').Store} store
 * @param {readonly Project[]} [drawn] states to go back to
 * @returns {Snapshot}
 */
export function snapshotOf(store, drawn = []) {
  const { gesture: _gesture, ...history } = store.history.peek();
  const album = store.album.peek();
  const facts = [...photosOf({ ...history, past: [...history.past, ...drawn] })].flatMap((id) => album.get(id) ?? []);
  const needed = new Set(facts.map(({ id }) => id));
  const videos = [...store.videos.peek().values()].filter(({ ids }) => ids.some((id) => needed.has(id)));
  return { place: store.place.peek(), history, drawn, facts, videos };
}

/**
 * @param {Omit<History, 'gesture'>} history
 * @returns {Set<string>} the photos of all times
 */
export function photosOf({ past, present, future, shown }) {
  /** @type {Set<string>} */
  const ids = new Set();
  // Most states have the tray of their neighbour.
  const seen = new Set();
  const states = [present, ...past, ...future];
  const once = (/** @type {unknown} */ part, /** @type {() => void} */ look) => {
    if (!seen.has(part)) look();
    seen.add(part);
  };
  for (const { tray } of states) once(tray, () => tray.forEach(({ id }) => ids.add(id)));
  const others = states.flatMap((state) => state.others.map(({ page }) => page));
  const pages = [...states.map(({ page }) => page), ...others, ...shown.map(({ page }) => page)];
  for (const page of pages) {
    if (page) once(page, () => page.panels.forEach(({ photo }) => photo !== null && ids.add(photo)));
  }
  return ids;
}
