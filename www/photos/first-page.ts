/**
 * The first page. It is a sketch with empty panels until enough photos are read. Then it is planned once more with
 * their measurements.
 */

import { batch, effect, signal } from '@preact/signals';
import { chronological } from '../document/album.ts';
import { USUAL_PANELS } from '../engine/bounds.ts';
import { createTimer } from '../engine/scheduler.ts';
import { onePerShot } from './one-per-shot.ts';
import { pagesOfText } from './pages-of-text.ts';
import type { Signal } from '@preact/signals';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { PhotoMeta } from '../engine/types.ts';

/** Milliseconds after the photos of a page are there, in which faces are found at most; more where the nets are still being made. */
const WAIT = 120;
const LONGER_WAIT = 250;
/** Maximum wait for faces after all photos are read, in milliseconds. The sketch is visible meanwhile. */
const FACE_WAIT = 1500;
/** Milliseconds that the page waits for the others, as far as one can tell: of look-alikes it should have the best. */
const PATIENCE = 250;
const ALL_NEW = Object.freeze({ layout: false, style: false, photos: false });

/**
 * `facesReady`: whether face detection can start immediately; `isDraft`: whether only a smaller copy of a photo was
 * read; `detects`: whether faces are detected at all
 */
export function createFirstPage({
  store,
  pages,
  facesReady = () => true,
  isDraft = () => false,
  detects = false,
}: {
  store: Store;
  pages: Pick<Pages, 'plan' | 'show' | 'compose'>;
  facesReady?: () => boolean;
  isDraft?: (id: string) => boolean;
  detects?: boolean;
}) {
  /** Whether its photos are being read, or planning is about to start. Not while photos replace others. */
  const near = signal(false);
  /** The version of the page that was composed, and the time. */
  const composed: Signal<{ version: string; at: number } | null> = signal(null);
  const timer = createTimer();
  /** The page that is the sketch, and since when. */
  let sketched = '';
  let since = 0;
  /** Whether all photos are read and only faces are missing. */
  let finishing = false;

  effect(() => {
    const { page } = store.project.value;
    near.value = false;
    if (!store.sketch.value) return end();
    // Who shuffles, or opens something else, no longer waits for it.
    if (page === null || store.version.value !== sketched) {
      store.sketch.value = false;
      return end();
    }
    const read = new Set(store.facts.value.filter(({ meta }) => meta !== null).map(({ id }) => id));
    // If the timer runs, there were enough photos before, and planning them again takes time.
    const enough = timer.runs || isEnough(read);
    // The wait ends when all photos are read.
    const soon = restOf(read.size) <= PATIENCE && ![...read].some(isDraft);
    // A video is read for long, so its first page waits longer for faces.
    const patience = detects && areFrames(read) ? FACE_WAIT : facesReady() ? WAIT : LONGER_WAIT;
    if (enough && !timer.runs) timer.start(soon ? 2 * PATIENCE : patience, compose);
    if (enough && (!soon || finishing) && [...read].every((id) => store.faced.value.has(id))) timer.start(0, compose);
    // Frames arrive in the order of their video, mixed with the frames of the page.
    const unread = page.panels.flatMap(({ photo }) => (photo !== null && !read.has(photo) ? [photo] : []));
    near.value = enough ? !soon : unread.length > 0 && unread.every((id) => store.originals.has(id));
    return undefined;
  });

  return { sketch, finish, near, composed };

  /** Whether a page can be made of the photos that were read. Pages of text do not count as long as others may come. */
  function isEnough(read: ReadonlySet<string>): boolean {
    const total = store.tray.value.length;
    if (read.size < Math.min(USUAL_PANELS, total)) return false;
    const texts = pagesOfText(
      store,
      store.photos.peek().filter(({ id }) => read.has(id)),
    );
    return read.size - texts.size >= Math.min(USUAL_PANELS, total - texts.size);
  }

  function areFrames(ids: ReadonlySet<string>): boolean {
    return [...ids].every((id) => store.album.peek().get(id)?.video !== undefined);
  }

  /** estimated milliseconds for the remaining photos */
  function restOf(read: number): number {
    return ((performance.now() - since) / read) * (store.tray.peek().length - read);
  }

  /** A page of as many panels as the first will have. */
  function sketch() {
    const panels = Math.min(store.photos.peek().length, USUAL_PANELS);
    // Each photo once: a first page says what there is.
    const page = pages.plan({ keep: ALL_NEW, panels });
    batch(() => {
      pages.show(page, { silent: true });
      sketched = store.version.peek();
      since = performance.now();
      store.sketch.value = page !== null;
    });
  }

  /**
   * Plans the first page after all photos are read. The page is about people, so it waits a moment for their faces.
   * @returns whether there is a page to plan
   */
  function finish(): boolean {
    const faced = store.faced.peek();
    if (!detects || !store.sketch.peek() || known().every(({ id }) => faced.has(id))) return compose();
    end();
    finishing = true;
    timer.start(FACE_WAIT, compose);
    return true;
  }

  /**
   * Plans the first page on the photos that are read.
   * @returns whether there was one to be planned
   */
  function compose(): boolean {
    if (!store.sketch.peek()) return false;
    const all = known();
    const photos = onePerShot(all, store.album.peek(), Math.min(all.length, USUAL_PANELS));
    if (photos.length === 0) return false;
    // The panels that the user sees already stay where they are.
    const sketch = store.page.peek();
    const panels = Math.min(photos.length, USUAL_PANELS);
    const layout = sketch?.panels.length === panels ? sketch.layout : undefined;
    const ids = photos.map(({ id }) => id);
    batch(() => {
      pages.compose({ photos: ids, panels, layout }, { silent: true });
      store.sketch.value = false;
      composed.value = { version: store.version.peek(), at: performance.now() };
    });
    return true;
  }

  /** The photos that were read without look-alikes, in the order in which they were taken. */
  function known(): PhotoMeta[] {
    const planner = store.planner.peek();
    if (!planner) return [];
    const kept = new Set(
      planner
        .choose(store.measured.peek(), store.project.peek().alike)
        .filter((verdict) => verdict.kept)
        .map(({ id }) => id),
    );
    const metas = new Map(store.photos.peek().map((meta) => [meta.id, meta]));
    const facts = store.facts.peek().filter(({ id, meta }) => meta !== null && kept.has(id) && metas.has(id));
    const ordered = store.project.peek().order === 'time' ? chronological(facts) : facts;
    return ordered.flatMap(({ id }) => metas.get(id) ?? []);
  }

  function end() {
    timer.stop();
    finishing = false;
  }
}
