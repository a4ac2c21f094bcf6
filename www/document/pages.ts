/** Page commands: shuffle, choose, lock, adjust, browse the page history. */

import { nextTask } from '../engine/scheduler.ts';
import { position, versions } from './history.ts';
import { photosOn, sheetsOf } from '../engine/sheets.ts';
import type { Draw, Wish } from '../engine/core.ts';
import type { BookWish, LayoutChoice, PageDocument, PageSettings, StyleChoice } from '../engine/types.ts';
import type { Shown } from './history.ts';
import type { Part, Project } from './project.ts';
import type { Sheet } from '../engine/sheets.ts';
import type { Store } from './store.ts';

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

/** Number of seeds that are tried for another arrangement of photos. A single photo has only one arrangement. */
const MOST_TRIES = 5;

/** @returns a seed that was likely never used */
export function freshSeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0];
}

/**
 * @param app `asked` adds the user's preferences to a wish. `narrated` adds a title and captions to a new page. `settled` places
 * text so that it covers no face. `shuffled` is called after a shuffle.
 */
export function createPages(
  store: Store,
  {
    seed = freshSeed,
    asked = (wish) => wish,
    narrated = (page) => page,
    settled = (page) => page,
    shuffled = () => {},
  }: {
    seed?: () => number;
    asked?: (wish: Wish) => Wish;
    narrated?: (page: PageDocument, at: number) => PageDocument;
    settled?: (page: PageDocument) => PageDocument;
    shuffled?: () => void;
  } = {},
) {
  /** The prepared page for the next shuffle, valid while nothing changes. */
  let prepared: { project: Project; photos: readonly unknown[]; page: PageDocument | null } | null = null;

  return {
    plan,
    show,
    amend,
    refine,
    refined,
    recropped,
    refit,
    shuffle,
    prepare,
    chooseLayout,
    chooseStyle,
    lock,
    wantPanels,
    changeSettings,
    another,
    spread,
    book,
    repaired,
    bringBack,
    previous,
    next,
    undo,
    redo,
  };

  /** Plans a new page from the photos in use that are free for it; null without photos. */
  function plan(wish: Wish): PageDocument | null {
    if (!canPlan()) return null;
    const page = store.project.peek().settings;
    const order = areFrames() ? { ordered: true } : {};
    const planned = store.plans().page({ page, ...order, ...asked(wish), seed: wish.seed ?? seed() });
    const isNew = !wish.keep.layout || !wish.keep.photos;
    return settledOr(planned && isNew ? narrated(planned, store.project.peek().at) : planned);
  }

  /** Frames of videos tell something in their order; photos without dates do not. */
  function areFrames() {
    const album = store.album.peek();
    return store.photos.peek().every(({ id }) => album.get(id)?.video !== undefined);
  }

  function canPlan() {
    return store.planner.peek() !== null && store.photos.peek().length > 0;
  }

  /** Learned preferences for the random choice of layouts. */
  function draw(): Draw {
    return { seed: seed(), taste: asked({ keep: { ...KEEP_ALL, layout: false } }).taste };
  }

  function settledOr(page: PageDocument | null): PageDocument | null {
    return page && settled(page);
  }

  /** Makes a page the page. */
  function show(page: PageDocument | null, how?: { silent?: boolean; gesture?: string }) {
    if (page && page !== store.page.peek())
      store.change({ type: 'show-page', page, pageId: store.fresh().pageId, ...how });
  }

  /** Sets the page after a manual change. */
  function amend(changed: PageDocument, how?: { gesture?: string }) {
    const page = plan({ keep: KEEP_ALL, current: changed, seed: changed.seed });
    if (page) store.change({ type: 'change-page', page, ...how });
  }

  /** Updates the crops of the page to the current measurements of its photos. */
  function refine() {
    const better = refined();
    if (better) store.change({ type: 'change-page', page: better, silent: true });
  }

  /** @returns the page with updated crops; null if nothing changes */
  function refined(): PageDocument | null {
    const { page } = store.project.peek();
    const better = page && recropped(page);
    return JSON.stringify(better) === JSON.stringify(page) ? null : better;
  }

  /**
   * Plans the crops of a page again. The panel of a missing photo stays unchanged, because its empty frame has other
   * measurements than the photo.
   * @param wish `current` and `photos` for a page that is not the edited one
   */
  function recropped(page: PageDocument, wish: Pick<Wish, 'current' | 'photos'> = {}): PageDocument | null {
    const album = store.album.peek();
    const better = plan({ keep: KEEP_ALL, seed: page.seed, ...wish });
    if (!better?.panels.some(({ photo }) => photo && album.get(photo)?.absent)) return better;
    const panels = better.panels.map((panel, i) => {
      const before = page.panels[i];
      return before && panel.photo === before.photo && album.get(panel.photo ?? '')?.absent ? before : panel;
    });
    return { ...better, panels };
  }

  /**
   * Returns the page after the photos in use changed, with as few changes as possible.
   * @param how whether there are more photos than before
   */
  function refit({ grow }: { grow: boolean }): PageDocument | null {
    const next = canPlan() ? settledOr(store.plans().refitted(draw(), grow)) : null;
    const page = store.page.peek();
    return JSON.stringify(next) === JSON.stringify(page) ? page : next;
  }

  /**
   * Changes size, gutter, paper and other settings of all pages of the storyboard.
   * @param gesture names one drag of a control, which is one step of the undo
   * @param how `held`: the user still holds the control. The other pages then wait for the call without it, which ends
   * the drag: to plan all of an album at each step would hold the slider up
   */
  function changeSettings(wish: Partial<PageSettings>, gesture?: string, { held = false }: { held?: boolean } = {}) {
    const project = store.project.peek();
    const { settings, page, at } = project;
    const changed = { ...settings, ...wish };
    if (held && page && project.others.length > 0) {
      const own = photosOn([page]);
      const photos = store.photos.peek().filter(({ id }) => own.has(id));
      const wanted: Wish = { keep: KEEP_ALL, seed: page.seed, page: changed };
      const alone = plan(photos.length > 0 ? { ...wanted, photos } : wanted);
      if (alone) store.change({ type: 'change-settings', settings: changed, page: alone, gesture });
      return;
    }
    const made = page ? store.plans().onPaper(draw(), changed).map(settled) : [];
    store.change({ type: 'change-settings', settings: changed, page: page && made[at], gesture });
    if (made.length < 2) return;
    const sheets = sheetsOf(project).map((sheet, i) => ({ ...sheet, page: made[i] }));
    store.change({ type: 'set-sheets', sheets, at, silent: true });
  }

  /** Plans a page to follow this one, in its style. It uses unplaced photos as long as there are any. */
  function another(): PageDocument | null {
    const page = canPlan() ? store.plans().another(draw()) : null;
    return settledOr(page && narrated(page, store.project.peek().at + 1));
  }

  /** Distributes all photos in use over as many pages as needed, replacing the present pages. */
  function spread(): Sheet[] {
    const sheets = canPlan() ? store.plans().spread(draw()) : null;
    return (sheets ?? []).map((sheet, i) => ({ ...sheet, page: settled(narrated(sheet.page, i)) }));
  }

  /**
   * Makes a book of the photos in use, page by page.
   * @param told is called with the number of pages that are planned, and with their number
   * @returns its pages; null if it was cancelled, or if the photos changed meanwhile
   */
  async function book(
    wish: BookWish,
    told: (done: number, of: number) => void,
    signal: AbortSignal,
  ): Promise<Sheet[] | null> {
    const maker = canPlan() ? store.plans().book(draw(), wish) : null;
    if (!maker) return null;
    const { tray } = store.project.peek();
    let more = maker.length > 0;
    for (let done = 0; more; done += 1) {
      told(done, maker.length);
      await nextTask();
      if (signal.aborted || store.project.peek().tray !== tray) {
        maker.stop();
        return null;
      }
      more = maker.step();
    }
    return maker.sheets().map((sheet) => ({ ...sheet, page: settled(sheet.page) }));
  }

  /** Replaces missing photos on all pages and removes pages without photos; null if nothing changes. */
  function repaired(): { sheets: Sheet[]; at: number } | null {
    if (!store.planner.peek() || !store.plans().torn()) return null;
    const groups = Object.fromEntries([...store.verdicts.peek().values()].map(({ id, group }) => [id, group]));
    const found = store.plans().repaired(draw(), groups);
    if (!found) return null;
    const before = new Map(sheetsOf(store.project.peek()).map((sheet) => [sheet.sheet, sheet]));
    const sheets = found.sheets.flatMap(({ page, ...ids }) => {
      if (page) return { ...ids, page: settled(page) };
      return before.get(ids.sheet) ?? [];
    });
    return { ...found, sheets };
  }

  function shuffle(part: Part | 'all') {
    const { locks, page } = store.project.peek();
    if (!page || (part !== 'all' && locks[part])) return;
    if (part === 'all') show(isPrepared() ? (prepared?.page ?? null) : planShuffled(page));
    else if (part === 'photos') show(otherPhotos(page));
    else show(plan({ keep: { ...KEEP_ALL, [part]: false } }));
    shuffled();
  }

  /** Avoids the previous arrangement of photos, which would not look like a shuffle. */
  function otherPhotos(page: PageDocument) {
    const places = ({ panels }: PageDocument) => panels.map(({ photo }) => photo).join();
    const another = () => plan({ keep: { ...KEEP_ALL, photos: false }, mode: 'photos' });
    let next = another();
    for (let tries = 1; tries < MOST_TRIES && next && places(next) === places(page); tries += 1) next = another();
    return next;
  }

  function planShuffled(page: PageDocument) {
    const { locks } = store.project.peek();
    // A locked panel does not move.
    const layout = locks.layout || page.panels.some((panel) => panel.locked);
    return plan({ keep: { ...locks, layout }, mode: 'shuffle' });
  }

  function isPrepared() {
    return prepared?.project === store.project.peek() && prepared.photos === store.photos.peek();
  }

  /** Plans the page of the next shuffle. @returns null if there is nothing to shuffle */
  function prepare(): PageDocument | null {
    const project = store.project.peek();
    if (!isPrepared()) {
      const page = project.page && planShuffled(project.page);
      prepared = { project, photos: store.photos.peek(), page };
    }
    return prepared?.page ?? null;
  }

  function chooseLayout(layout: LayoutChoice) {
    show(plan({ keep: { ...KEEP_ALL }, layout }));
  }

  function chooseStyle(style: StyleChoice) {
    show(plan({ keep: { ...KEEP_ALL }, style }));
  }

  function lock(part: Part, on: boolean) {
    store.change({ type: 'lock', part, on });
  }

  function wantPanels(count: number | null) {
    const gesture = `panels-${count}`;
    store.change({ type: 'want-panels', count, gesture });
    const { page } = store.project.peek();
    if (count === null || !page || page.panels.length === count) return;
    show(plan({ keep: { ...KEEP_ALL, layout: false } }), { gesture });
  }

  function walk(step: number) {
    const history = store.history.peek();
    const target = versions(history)[position(history) + step];
    if (target) bringBack(target);
  }

  /**
   * Restores a page of the page history, in its place in the storyboard. If that position does not exist any more, it
   * replaces the current page.
   */
  function bringBack({ id, page, sheet = 0 }: Shown) {
    const sheets = sheetsOf(store.project.peek());
    const at = sheets.findIndex((other) => other.pageId === id || other.sheet === sheet);
    // Turning pages is not an undo step.
    if (at >= 0 && at !== store.project.peek().at) store.change({ type: 'set-sheets', sheets, at, silent: true });
    if (sheets[at]?.pageId !== id) store.change({ type: 'show-page', page: broughtBack(page), pageId: id });
  }

  /** Returns an earlier version of a page in its current form. */
  function broughtBack(page: PageDocument): PageDocument {
    const back = store.plans().broughtBack(draw(), page);
    return JSON.stringify(back) === JSON.stringify(page) ? page : settled(back);
  }

  function previous() {
    walk(-1);
  }

  function next() {
    walk(1);
  }

  function undo() {
    store.change({ type: 'undo' });
  }

  function redo() {
    store.change({ type: 'redo' });
  }
}

export type Pages = ReturnType<typeof createPages>;
