/**
 * What a person does to the page: shuffle, choose, lock, set, walk through what was shown.
 */

import { position, versions } from './history.ts';
import { casting, photosFor, placesOf } from './page-photos.ts';
import { createPageSettings } from './page-settings.ts';
import { sheetsOf } from './sheets.ts';
import type { PlanRequest } from '../engine/core.ts';
import type { Keep, LayoutChoice, PageDocument, StyleChoice } from '../engine/types.ts';
import type { Shown } from './history.ts';
import type { Part, Project } from './project.ts';
import type { Store } from './store.ts';

/** A page of more panels than this is a page of stamps, unless a person asks for it. */
const MOST_PANELS = 9;

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

/** @returns a seed that was likely never used */
export function freshSeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0];
}

export function createPages(store: Store, seed: () => number = freshSeed) {
  const settings = createPageSettings({ store, plan });
  /** The page that a shuffle shows next, as long as all is as it was when it was planned. */
  let prepared: { project: Project; photos: readonly unknown[]; page: PageDocument | null } | null = null;

  return {
    plan,
    show,
    amend,
    refine,
    refined,
    refit,
    shuffle,
    prepare,
    chooseLayout,
    chooseStyle,
    lock,
    wantPanels,
    changeSettings: settings.changeSettings,
    bringBack,
    previous,
    next,
    undo,
    redo,
  };

  /** A new page from the photos in use that are free for it; null while there are none. */
  function plan(wish: Parameters<Plan>[0]): ReturnType<Plan> {
    const planner = store.planner.peek();
    const project = store.project.peek();
    const photos = store.photos.peek();
    if (!planner || photos.length === 0) return null;
    const free = !wish.keep.layout && wish.layout === undefined;
    const request = { seed: seed(), page: project.settings, current: project.page, ...(free ? shape() : {}), ...wish };
    return planner.plan({
      ...request,
      ...(wish.photos ? { photos: wish.photos } : casting(request, photos, elsewhere(), planner)),
    });
  }

  /** The other pages of the storyboard. */
  function elsewhere() {
    return store.project.peek().others.map(({ page }) => page);
  }

  /** What a free layout must have: the number of panels that a person wants, or else a place for each locked photo. */
  function shape(): Partial<PlanRequest> {
    const { page, panels, locks } = store.project.peek();
    const places = locks.photos && page ? { panels: placesOf(page) } : {};
    return panels === null ? places : { ...places, panels };
  }

  /** Makes a page the page. */
  function show(page: PageDocument | null, how?: { silent?: boolean; gesture?: string }) {
    if (page && page !== store.page.peek())
      store.change({ type: 'show-page', page, pageId: store.fresh().pageId, ...how });
  }

  /** The page after a change by hand; what it does not touch stays. */
  function amend(changed: PageDocument, how?: { gesture?: string }) {
    const page = plan({ keep: KEEP_ALL, current: changed, seed: changed.seed });
    if (page) store.change({ type: 'change-page', page, ...how });
  }

  /** Fits the crops of the page to what is known of its photos by now. */
  function refine() {
    const better = refined();
    if (better) store.change({ type: 'change-page', page: better, silent: true });
  }

  /** @returns the page with crops that fit what is known of its photos by now; null where it has them already */
  function refined(): PageDocument | null {
    const { page } = store.project.peek();
    const better = page && plan({ keep: KEEP_ALL, seed: page.seed });
    return JSON.stringify(better) === JSON.stringify(page) ? null : better;
  }

  /**
   * A page after the photos in use changed: as it was where it can be.
   * @param how whether there are more photos than before
   */
  function refit({ grow }: { grow: boolean }): PageDocument | null {
    const { page, locks, panels, others } = store.project.peek();
    if (page && others.length > 0) return refitAmong(page);
    const enough = page !== null && store.photos.peek().length >= page.panels.length;
    const layout = locks.layout || (panels !== null && page?.panels.length === panels) || (enough && !grow);
    // A photo that was just added is looked for on the page, so each gets a panel.
    const all = grow && !layout && panels === null ? { panels: Math.min(store.photos.peek().length, MOST_PANELS) } : {};
    return plan({ keep: { layout, style: true, photos: locks.photos || !grow }, ...all });
  }

  /** The same for a page among others: what is new goes to no page by itself, and a page loses but what is gone. */
  function refitAmong(page: PageDocument) {
    const { length } = photosFor(store.photos.peek(), elsewhere(), page);
    const layout = length === 0 || length >= placesOf(page);
    const next = plan({ keep: { ...KEEP_ALL, layout }, seed: page.seed, ...(layout ? {} : { panels: length }) });
    return JSON.stringify(next) === JSON.stringify(page) ? page : next;
  }

  function shuffle(part: Part | 'all') {
    const { locks, page } = store.project.peek();
    if (!page || (part !== 'all' && locks[part])) return;
    if (part === 'all') show(isPrepared() ? (prepared?.page ?? null) : planShuffled(page));
    else if (part === 'photos') show(plan({ keep: { ...KEEP_ALL, photos: false }, mode: 'photos' }));
    else show(plan({ keep: { ...KEEP_ALL, [part]: false } }));
  }

  function planShuffled(page: PageDocument) {
    const { locks } = store.project.peek();
    // A locked panel stays where it is.
    const layout = locks.layout || page.panels.some((panel) => panel.locked);
    return plan({ keep: { ...locks, layout }, mode: 'shuffle' });
  }

  function isPrepared() {
    return prepared?.project === store.project.peek() && prepared.photos === store.photos.peek();
  }

  /** Plans the page that the next shuffle shows. @returns null where there is nothing to shuffle */
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

  /** Shows a page that was shown before, in its place in the storyboard, or where that is gone in the place of the present one. */
  function bringBack({ id, page, sheet = 0 }: Shown) {
    const sheets = sheetsOf(store.project.peek());
    const at = sheets.findIndex((other) => other.pageId === id || other.sheet === sheet);
    // To turn the pages is no step of the undo.
    if (at >= 0 && at !== store.project.peek().at) store.change({ type: 'set-sheets', sheets, at, silent: true });
    if (sheets[at]?.pageId !== id) store.change({ type: 'show-page', page: settings.fitted(filled(page)), pageId: id });
  }

  /** A page that was shown before, with other photos where its own are not on the table any more. */
  function filled(page: PageDocument): PageDocument {
    const table = new Set(store.tray.peek().map(({ id }) => id));
    const whole = page.panels.every(({ photo }) => photo !== null && table.has(photo));
    return whole ? page : (plan({ keep: KEEP_ALL, current: page, seed: page.seed }) ?? page);
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

/** `photos` says which are free for it, if not those that no other page shows */
export type Plan = (wish: Partial<PlanRequest> & { keep: Keep }) => PageDocument | null;
export type Pages = ReturnType<typeof createPages>;
