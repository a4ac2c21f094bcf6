/** Tests a project before it is opened. The exchange is one step that can be reverted. */

import { Priority } from '../engine/queue.ts';
import { unreadMeta } from '../document/album.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { createEditing } from '../document/editing.ts';
import { createStore } from '../document/store.ts';
import type { Editing } from '../document/editing.ts';
import type { SharedLists } from '../document/project.ts';
import type { Planner, Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { createPhotos } from '../engine/photos.ts';
import type { Place } from '../document/place.ts';
import type { Content } from './restoring.ts';

type Photos = ReturnType<typeof createPhotos>;
/** A project that can be shown. */
export type Rehearsed = Content & { editing: Editing };

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });
/** Width of the invisible page in pixels. */
const WIDTH = 64;
/** The project is at fault, not a photo of it nor the device. */
const FAULTS = /^(?:(?:invalid|unknown)-(?:document|layout|style)|worker-lost)$/;

/**
 * Loads a project into a hidden store and computes everything that the app needs from it.
 * @param app `shared`: the lists of all projects; `join`: adds the lists of this project to them
 * @returns the project with these lists, and its editor; throws the errors of the app
 */
export function rehearsed(
  content: Content,
  { planner, shared, join = false }: { planner: Planner; shared: Partial<SharedLists>; join?: boolean },
): Rehearsed {
  const editing = content.editing ?? createEditing(planner.createEditor(), content.history);
  editing.apply({ type: join ? 'join' : 'share', lists: shared });
  const whole = { ...content, editing };
  const stage = createStore();
  stage.planner.value = planner;
  stage.load(whole);
  for (const part of [stage.layouts, stage.layoutFacts, stage.geometry]) part.peek();
  const known = new Map(stage.photos.peek().map((photo) => [photo.id, photo]));
  for (const { page } of sheetsOf(stage.project.peek())) {
    const ids = [...new Set([...page.panels.flatMap(({ photo }) => photo ?? []), ...page.order])];
    if (ids.length === 0) continue;
    planner.plan({
      seed: page.seed,
      photos: ids.map((id) => known.get(id) ?? unreadMeta(id)),
      page: page.page,
      current: page,
      keep: KEEP_ALL,
    });
  }
  return whole;
}

/**
 * Draws the page of a project in a small size.
 * @returns rejects if the engine does not accept the page
 */
export async function drawnOnce(
  { editing, records }: Rehearsed,
  { photos, renderPage }: { photos: Photos; renderPage: Engine['renderPage'] },
): Promise<void> {
  const { page } = editing.mirror().present;
  if (!page) return;
  const fresh = addTo(photos, records);
  try {
    // Photos that are still to be read have no part in it.
    const panels = page.panels.map((panel) =>
      panel.photo !== null && photos.has(panel.photo) ? panel : { ...panel, photo: null },
    );
    const { bitmap } = await renderPage({ ...page, panels }, WIDTH, { priority: Priority.PAGE });
    bitmap.close();
  } catch (error) {
    if (FAULTS.test(String((error as { code?: unknown }).code))) throw error;
  } finally {
    fresh.forEach(photos.forget);
  }
}

/**
 * Makes a project the open one. On an error everything is restored.
 * @param place its storage place
 * @returns two functions: one confirms the exchange, the other reverts it
 */
export function exchanged(
  { editing, album, videos, records }: Rehearsed,
  place: Place,
  { store, photos }: { store: Store; photos: Photos },
): { settle: () => void; takeBack: () => void } {
  const before = {
    editing: store.editing(),
    album: store.album.peek(),
    videos: store.videos.peek(),
    place: store.place.peek(),
  };
  const fresh = addTo(photos, records);
  const takeBack = () => {
    store.load(before);
    fresh.forEach(photos.forget);
  };
  try {
    store.load({ editing, album, videos, place });
  } catch (error) {
    takeBack();
    throw error;
  }
  const settle = () => {
    for (const id of before.album.keys()) if (!album.has(id)) photos.forget(id);
  };
  return { settle, takeBack };
}

/** @returns the ids of the added photos */
function addTo(photos: Photos, records: Content['records']): string[] {
  return records.flatMap(({ id, name, file, work, small }) => {
    if (!work || !small || photos.has(id)) return [];
    // A missing file affects only the export, which reports it.
    photos.add(id, { name, file: file ?? new Blob(), work, small });
    return [id];
  });
}
