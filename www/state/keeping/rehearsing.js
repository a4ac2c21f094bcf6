// @ts-check
/**
 * A project is tried before it takes the place of the one on the page, and the change of places is one step that can be
 * taken back.
 */

import { Priority } from '../../engine/queue.js';
import { unreadMeta } from '../album.js';
import { rebased } from '../shared-lists.js';
import { sheetsOf } from '../sheets.js';
import { createStore } from '../store.js';

/** @typedef {import('./restoring.js').Content} Content */
/** @typedef {ReturnType<typeof import('../../engine/photos.js').createPhotos>} Photos */

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });
/** Pixels of a page that nobody sees. */
const WIDTH = 64;
/** The project is at fault, not a photo of it nor the device. */
const FAULTS = /^(?:(?:invalid|unknown)-(?:document|layout|style)|worker-lost)$/;

/**
 * Shows a project to nobody: in a store beside the page's, all that the page will ask for is worked out.
 * @param {Content} content
 * @param {{ planner: import('../store.js').Planner, shared: Partial<import('../shared-lists.js').SharedLists> }} app `shared`: the
 *   lists that all projects have in common
 * @returns {Content} with these lists; throws what the page would
 */
export function rehearsed(content, { planner, shared }) {
  const whole = { ...content, history: rebased(content.history, shared) };
  const stage = createStore();
  stage.planner.value = planner;
  stage.load(whole);
  for (const part of [stage.layouts, stage.layoutFacts, stage.geometry]) part.peek();
  const known = new Map(stage.photos.peek().map((photo) => [photo.id, photo]));
  for (const { page } of sheetsOf(stage.project.peek())) {
    const ids = [...new Set([...page.panels.flatMap(({ photo }) => photo ?? []), ...page.order])];
    if (ids.length === 0) continue;
    planner.plan({ seed: page.seed, photos: ids.map((id) => known.get(id) ?? unreadMeta(id)), page: page.page, current: page, keep: KEEP_ALL });
  }
  return whole;
}

/**
 * Has the engine draw the page of a project, in a size that takes no time.
 * @param {Content} content
 * @param {{ photos: Photos, renderPage: import('../../engine/engine.js').Engine['renderPage'] }} engine
 * @returns {Promise<void>} rejects where the engine does not take the page
 */
export async function drawnOnce({ history, records }, { photos, renderPage }) {
  const { page } = history.present;
  if (!page) return;
  const fresh = addTo(photos, records);
  try {
    // Photos that are still to be read have no part in it.
    const panels = page.panels.map((panel) => (panel.photo !== null && photos.has(panel.photo) ? panel : { ...panel, photo: null }));
    const { bitmap } = await renderPage({ ...page, panels }, WIDTH, { priority: Priority.PAGE });
    bitmap.close();
  } catch (error) {
    if (FAULTS.test(String(/** @type {{ code?: unknown }} */ (error).code))) throw error;
  } finally {
    fresh.forEach(photos.forget);
  }
}

/**
 * Makes a project the one on the page; when that fails, everything is as it was.
 * @param {Content} content
 * @param {import('../place.js').Place} place where it is kept
 * @param {{ store: import('../store.js').Store, photos: Photos }} app
 * @returns {{ settle: () => void, takeBack: () => void }} one of which is called when it is known whether it can stay
 */
export function exchanged({ history, album, videos, records }, place, { store, photos }) {
  const before = { history: store.history.peek(), album: store.album.peek(), videos: store.videos.peek(), place: store.place.peek() };
  const fresh = addTo(photos, records);
  const takeBack = () => {
    store.load(before);
    fresh.forEach(photos.forget);
  };
  try {
    store.load({ history, album, videos, place });
  } catch (error) {
    takeBack();
    throw error;
  }
  const settle = () => {
    for (const id of before.album.keys()) if (!album.has(id)) photos.forget(id);
  };
  return { settle, takeBack };
}

/** @param {Photos} photos @param {Content['records']} records @returns {string[]} the ids of those that were not there */
function addTo(photos, records) {
  return records.flatMap(({ id, name, file, work, small }) => {
    if (!work || !small || photos.has(id)) return [];
    // A file that could not be kept is missed by the export alone, which says so.
    photos.add(id, { name, file: file ?? new Blob(), work, small });
    return [id];
  });
}
