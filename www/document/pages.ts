/** Page commands: shuffle, choose, lock, adjust, browse the page history. */

import { batch } from '@preact/signals';
import { mentionsPainter } from '../engine/painters.ts';
import { nextTask } from '../engine/scheduler.ts';
import { sheetsOf } from '../engine/sheets.ts';
import type { Wish } from '../engine/core.ts';
import type {
  BookWish,
  Draw,
  Intent,
  LayoutChoice,
  PageDocument,
  PageSettings,
  Shuffled,
  StyleChoice,
} from '../engine/types.ts';
import type { Change, Shown } from './history.ts';
import type { Part, Project } from './project.ts';
import type { Sheet } from '../engine/sheets.ts';
import type { Store } from './store.ts';

/** @returns a seed that was likely never used */
export function freshSeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0];
}

/**
 * @param app `asked` adds the user's preferences to a wish. `narrated` adds a title and captions to a new page. `settled` places
 * text so that it covers no face; `before`: the page before an edit. `shuffled` is called after a shuffle.
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
    settled?: (page: PageDocument, before?: PageDocument | null) => PageDocument;
    shuffled?: () => void;
  } = {},
) {
  type Prepared = { project: Project; photos: readonly unknown[]; page: PageDocument | null };
  /** The prepared page for the next shuffle, valid while nothing changes. */
  let prepared: Prepared | null = null;
  /** A page that replaces it when it is drawn. */
  let slow: Prepared | null = null;

  return {
    plan,
    show,
    edit,
    preview,
    compose,
    refine,
    refit,
    shuffle,
    prepare,
    prepareSlow,
    drawn,
    chooseLayout,
    chooseStyle,
    lock,
    wantPanels,
    changeSettings,
    add,
    spread,
    book,
    repair,
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
    const planned = store.plans().page({ page, ...asked(wish), seed: wish.seed ?? seed() });
    const isNew = !wish.keep.layout || !wish.keep.photos;
    return settledOr(planned && isNew ? narrated(planned, store.project.peek().at) : planned);
  }

  function canPlan() {
    return store.planner.peek() !== null && store.photos.peek().length > 0;
  }

  /**
   * A seed, and the user's preferences for random choices.
   * @param styles whether a style is chosen
   * @param how `quick`: without styles that take seconds
   */
  function draw(styles = false, { quick = false }: { quick?: boolean } = {}): Draw {
    const { taste, styling } = asked({ keep: { layout: false, style: !styles, photos: true } });
    return { seed: seed(), ...(taste && { taste }), ...(styling && { styling: { ...styling, quick } }) };
  }

  function settledOr(page: PageDocument | null): PageDocument | null {
    return page && settled(page);
  }

  /** Makes a page the page. */
  function show(page: PageDocument | null, how?: { silent?: boolean; gesture?: string }) {
    if (page && page !== store.page.peek())
      store.change({ type: 'show-page', page, pageId: store.fresh().pageId, ...how });
  }

  /**
   * Applies an edit, and writes and places the text of the changed pages in the same undo step.
   * @param how `isNew`: whether the changed page at an index gets another title and other captions
   * @returns whether the current page changed
   */
  function edit(change: Change, { isNew = () => false }: { isNew?: (at: number) => boolean } = {}): boolean {
    const project = store.project.peek();
    const before = new Map(sheetsOf(project).map((sheet) => [sheet.sheet, sheet.page]));
    const versions = new Set(store.pageHistory.peek().map(({ page }) => page));
    // New measurements can move text even if the crops stay.
    const measured = change.type === 'recrop' ? (change.sheet ?? project.sheet) : null;
    batch(() => {
      store.change(change);
      const placed = sheetsOf(store.project.peek()).flatMap(({ sheet, page }, at) => {
        const was = before.get(sheet) ?? null;
        // A restored version is not changed.
        if (sheet !== measured && (page === was || versions.has(page))) return [];
        const { words = [] } = settled(isNew(at) ? narrated(page, at) : page, was);
        return JSON.stringify(words) === JSON.stringify(page.words ?? []) ? [] : [{ at, words }];
      });
      if (placed.length > 0) store.change({ type: 'set-words', pages: placed, silent: true });
    });
    return store.page.peek() !== project.page;
  }

  /**
   * @param how whether it gets another title and other captions
   * @returns the page that an intent would make the current page; null if it stays
   */
  function preview(intent: Intent, { isNew = false }: { isNew?: boolean } = {}): PageDocument | null {
    const page = canPlan() ? store.preview(intent) : null;
    return settledOr(page && isNew ? narrated(page, store.project.peek().at) : page);
  }

  /**
   * Plans all parts of the current page again.
   * @param how `accepts`: whether the planned page is good enough
   */
  function compose(
    wish: Omit<Extract<Intent, { type: 'compose' }>, 'type' | 'draw'>,
    { silent, accepts }: { silent?: boolean; accepts?: (page: PageDocument) => boolean } = {},
  ) {
    const intent = { type: 'compose', ...wish, draw: draw(wish.style === undefined) } as const;
    const page = accepts && canPlan() ? store.preview(intent) : null;
    if (!accepts || (page && accepts(page))) edit({ ...intent, silent }, { isNew: () => true });
  }

  /** Updates the crops of the page to the current measurements of its photos. */
  function refine() {
    edit({ type: 'recrop', silent: true });
  }

  /**
   * Plans the page again after the photos in use changed, with as few changes as possible.
   * @param how whether there are more photos than before, and the undo step or none
   */
  function refit({ grow, ...step }: { grow: boolean; gesture?: string; silent?: true }) {
    edit({ type: 'refit', grow, draw: draw(), ...step });
  }

  /**
   * Changes size, gutter, paper and other settings of all pages of the storyboard.
   * @param gesture names one drag of a control, which is one step of the undo
   * @param how `held`: the user still holds the control. The other pages then wait for the call without it, which ends
   * the drag
   */
  function changeSettings(wish: Partial<PageSettings>, gesture?: string, { held = false }: { held?: boolean } = {}) {
    const settings = { ...store.project.peek().settings, ...wish };
    edit({ type: 'set-paper', settings, held, taste: draw().taste, gesture });
  }

  /** Inserts a page after this one, in its style. It has unplaced photos as long as there are any. */
  function add(): boolean {
    const at = store.project.peek().at + 1;
    return edit({ type: 'add-page', draw: draw() }, { isNew: (place) => place === at });
  }

  /** Distributes all photos in use over as many pages as needed, replacing the present pages. */
  function spread(): boolean {
    return edit({ type: 'spread-album', draw: draw() }, { isNew: () => true });
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

  /** Replaces missing photos on all pages and removes pages without photos. */
  function repair() {
    if (!store.planner.peek() || !store.plans().torn()) return;
    const groups = Object.fromEntries([...store.verdicts.peek().values()].map(({ id, group }) => [id, group]));
    edit({ type: 'repair-pages', groups, taste: draw().taste, silent: true });
  }

  function shuffle(part: Shuffled) {
    const { locks, page } = store.project.peek();
    if (!page || (part !== 'all' && locks[part])) return;
    if (part === 'all') show(isPrepared() ? (prepared?.page ?? null) : planShuffled());
    else edit({ type: 'shuffle', part, draw: draw(part === 'style') }, { isNew: () => part !== 'style' });
    shuffled();
  }

  function planShuffled({ quick = true } = {}): PageDocument | null {
    const { locks, page } = store.project.peek();
    const isLaidOut = locks.layout || !!page?.panels.some((panel) => panel.locked);
    const intent = { type: 'shuffle', part: 'all', draw: draw(!locks.style, { quick }) } as const;
    return preview(intent, { isNew: !isLaidOut || !locks.photos });
  }

  function isPrepared() {
    const { project, photos } = now();
    return prepared?.project === project && prepared.photos === photos;
  }

  /** Plans the page of the next shuffle, in a style that is drawn at once. @returns null if there is nothing to shuffle */
  function prepare(): PageDocument | null {
    const { project, photos } = now();
    if (!isPrepared()) prepared = { project, photos, page: project.page && planShuffled() };
    return prepared?.page ?? null;
  }

  /**
   * Plans a page in any style.
   * @returns the page if its style takes seconds. It becomes the page of the next shuffle when it is `drawn`
   */
  function prepareSlow(): PageDocument | null {
    const { project, photos } = now();
    const page = project.page && !project.locks.style ? planShuffled({ quick: false }) : null;
    slow = { project, photos, page };
    return mentionsPainter(page?.style) ? page : null;
  }

  /** Notes that all pictures of a page are drawn in advance. */
  function drawn(page: PageDocument) {
    if (slow?.page === page) prepared = slow;
  }

  function now() {
    return { project: store.project.peek(), photos: store.photos.peek() };
  }

  function chooseLayout(layout: LayoutChoice) {
    edit({ type: 'choose-layout', layout, seed: seed() });
  }

  function chooseStyle(style: StyleChoice) {
    edit({ type: 'choose-style', style, seed: seed() });
  }

  function lock(part: Part, on: boolean) {
    store.change({ type: 'lock', part, on });
  }

  function wantPanels(count: number | null) {
    const gesture = `panels-${count}`;
    store.change({ type: 'want-panels', count, gesture });
    const { page } = store.project.peek();
    if (count === null || !page || page.panels.length === count) return;
    edit({ type: 'fit-layout', draw: draw(), gesture }, { isNew: () => true });
  }

  function walk(step: number) {
    const target = store.versions.peek()[store.versionIndex.peek() + step];
    if (target) bringBack(target);
  }

  /** Restores a page of the page history, in its place in the storyboard. */
  function bringBack({ id }: Pick<Shown, 'id'>) {
    edit({ type: 'restore-version', pageId: id, taste: draw().taste });
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
