/**
 * Plans the first page once more. The first page is composed when a few photos are read, so it may show receipts or
 * empty landscapes that came first. After all photos are read, a page with a better choice of photos replaces it once, in
 * the same layout and style. The choice is compared when all faces are known, and again when all objects are known. A page that was visible for a moment remains as a version, and the
 * replacement can be undone. A near-duplicate with open eyes also replaces one with shut eyes. A page
 * of a video that repeats shots also changes, because the shots are known when the video has been read. Any
 * action of the user keeps the page.
 */

import { effect, untracked } from '@preact/signals';
import { noteWithUndo } from '../ui/undo-note.ts';
import { photosOn } from '../engine/sheets.ts';
import { strings } from '../strings/strings.ts';
import { rankOf } from './hero.ts';
import { onePerShot, shotOf } from './one-per-shot.ts';
import { pagesOfText } from './pages-of-text.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Messages } from '../ui/messages.ts';

/** Maximum age in milliseconds of the first page. An older page does not change without the user. */
const OLDEST = 60_000;
/** Minimum time on the screen, in milliseconds. A younger page was not looked at, so it is replaced without a step. */
const LOOK = 1000;
/** Minimum gain in points: a person on the page, or an animal in the largest panel. */
const LEAST_GAIN = 2;
/** Points of a page of text, such as a receipt. */
const TEXT = -2;
/** Knowledge of all photos: their shots, also their faces, also their objects. */
type Known = 'shots' | 'faces' | 'objects';
/** Events of a user. */
const ACTS = ['pointerdown', 'keydown', 'wheel'];

/**
 * @param app `composed`: the version of the page that was composed, and the time; `faced`: whether all faces are known;
 *   `searched`: whether detection is done. `keepShown` keeps the photos of the page in use
 */
export function planAgain({
  store,
  pages,
  messages,
  composed,
  faced,
  searched,
  keepShown,
  window,
  now = () => performance.now(),
}: {
  store: Store;
  pages: Pick<Pages, 'compose' | 'undo'>;
  messages: Messages;
  composed: Signal<{ version: string; at: number } | null>;
  faced: ReadonlySignal<boolean>;
  searched: ReadonlySignal<boolean>;
  keepShown: () => void;
  window: Pick<Window, 'addEventListener'>;
  now?: () => number;
}) {
  /** The version and the knowledge at the last comparison of the choice. */
  let tried = '';
  const forget = () => {
    if (composed.peek() === null) return;
    composed.value = null;
    untracked(keepShown);
  };
  for (const act of ACTS) window.addEventListener(act, forget, { capture: true, passive: true });

  effect(() => {
    const { canUndo, version, reading } = store;
    if (composed.value === null) return;
    const { version: own, at } = composed.value;
    if (version.value !== own || canUndo.value) return forget();
    if (reading.value !== null || store.sketch.value) return;
    const known: Known = searched.value ? 'objects' : faced.value ? 'faces' : 'shots';
    // Other shots need no detection, which takes long for a video.
    const step = `${own} ${known}`;
    if (tried === step || (known === 'shots' && untracked(() => repeatsOf(store.page.peek())) === 0)) return;
    tried = step;
    if (known === 'objects') forget();
    const age = now() - at;
    if (age <= OLDEST) untracked(() => replace({ known, silent: age < LOOK }));
  });

  function replace({ known, silent }: { known: Known; silent: boolean }) {
    const page = store.page.peek();
    const hasFaces = known !== 'shots';
    const exchanged = hasFaces && page !== null && useOpenEyes(page);
    const album = store.album.peek();
    // Unread frames of a video have no place in its order.
    const all = store.photos.peek().filter(({ id }) => album.get(id)?.meta);
    const photos = page ? onePerShot(all, album, page.panels.length) : [];
    if (!page || (!exchanged && photos.length <= page.panels.length)) return;
    const { layout, style, panels } = page;
    const wish = { photos: photos.map(({ id }) => id), layout, style, panels: panels.length, surprise: 0 };
    pages.compose(wish, {
      silent,
      accepts: (better) =>
        exchanged || repeatsOf(better) < repeatsOf(page) || (hasFaces && worthOf(better) >= worthOf(page) + LEAST_GAIN),
    });
    if (!silent && store.page.peek() !== page) noteWithUndo({ messages, store, pages }, strings.betterPhotos);
  }

  /**
   * Uses near-duplicates with open eyes instead of photos of the page.
   * @returns whether there are any
   */
  function useOpenEyes(page: PageDocument): boolean {
    const shown = photosOn([page]);
    const verdicts = [...store.verdicts.peek().values()];
    const awake = verdicts.filter(({ id, why }) => why.startsWith('open eyes') && !shown.has(id));
    const uses = awake.flatMap(({ id, group }) => {
      const asleep = verdicts.filter((other) => other.group === group && shown.has(other.id));
      return asleep.length > 0 ? [[id, true] as const, ...asleep.map((other) => [other.id, false] as const)] : [];
    });
    if (uses.length > 0) store.change({ type: 'use-photos', uses: Object.fromEntries(uses), silent: true });
    return uses.length > 0;
  }

  /** Number of panels whose shot is on the page before. */
  function repeatsOf(page: PageDocument | null): number {
    const shots = page?.panels.flatMap(({ photo }) => shotOf(store.album.peek(), photo ?? '') ?? []) ?? [];
    return shots.length - new Set(shots).size;
  }

  /** Points for the people and animals of a page. The largest panel counts twice. */
  function worthOf(page: PageDocument): number {
    const boxes = store.geometry.peek()?.panels ?? [];
    const area = (i: number) => (boxes[i] ? boxes[i].bounds.width * boxes[i].bounds.height : 0);
    const largest = page.panels.reduce((best, _, i) => (area(i) > area(best) ? i : best), 0);
    const known = new Map(store.photos.peek().map((photo) => [photo.id, photo]));
    const texts = pagesOfText(store, store.photos.peek());
    const worth = (id: string | null) =>
      id !== null && texts.has(id) ? TEXT : Math.max(0, rankOf(known.get(id ?? '')));
    return page.panels.reduce((sum, { photo }, i) => sum + worth(photo) * (i === largest ? 2 : 1), 0);
  }
}
