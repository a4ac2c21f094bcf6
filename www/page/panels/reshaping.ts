/**
 * Manual changes of the layout: a generated layout, a moved divider or inset, a split or removed panel, joined panels. The
 * page then stores the complete layout, like any other page.
 */

import { signal } from '@preact/signals';
import { strings } from '../../strings/strings.ts';
import { grown } from './merging.ts';
import type { Pages } from '../../document/pages.ts';
import type { Store } from '../../document/store.ts';
import type { Bounds, LayoutChange, PageDocument, PanelUse } from '../../engine/types.ts';
import type { Signal } from '@preact/signals';

export type Reshaping = ReturnType<typeof createReshaping>;

/** Number of panels of a generated layout, if the user did not choose one. */
const USUAL = { least: 3, most: 8 };

const EMPTY: PanelUse = { photo: null, crop: null, locked: false, edited: false };

export function createReshaping({ store, pages, seed }: { store: Store; pages: Pages; seed: () => number }) {
  return {
    /** Whether the cuts show their handles. */
    editing: signal(false),
    /** The cut that was chosen last, by its place in the facts of the layout. */
    cut: signal(null) as Signal<number | null>,
    surprise,
    moveCut,
    moveInset,
    splitPanel,
    removePanel,
    cannotJoin,
    joinPanels,
  };

  /** Shows a generated layout with the chosen number of panels. */
  function surprise() {
    const planner = store.planner.peek();
    const { panels, settings, page } = store.project.peek();
    if (!planner || !page) return;
    const most = Math.max(USUAL.least, Math.min(USUAL.most, store.photos.peek().length));
    const count = panels === null ? { least: USUAL.least, most } : { least: panels, most: panels };
    pages.chooseLayout(planner.generateLayout({ seed: seed(), page: settings, ...count }));
  }

  /**
   * @param cut its place in the facts of the layout
   * @param gesture names the drag, which is one step of the undo
   */
  function moveCut(cut: number, to: { fraction: number; slant: number }, gesture: string) {
    change({ type: 'move-cut', cut, ...to }, (page) => page, gesture);
  }

  /**
   * @param bounds in page widths
   * @param gesture names the drag, which is one step of the undo
   */
  function moveInset(panel: number, bounds: Bounds, gesture: string) {
    change({ type: 'move-inset', panel, bounds }, (page) => page, gesture);
  }

  function splitPanel(panel: number, axis: 'rows' | 'columns') {
    change({ type: 'split', panel, axis }, (page) => spliced(page, panel, 1));
  }

  function removePanel(panel: number) {
    change({ type: 'remove', panel }, (page) => spliced(page, panel, -1));
  }

  /** @returns why those panels cannot become one; empty when they can */
  function cannotJoin(panels: readonly number[]): string {
    const planner = store.planner.peek();
    const page = store.page.value;
    if (!planner || !page || panels.length < 2) return strings.merging.few;
    try {
      planner.changeLayout(page.layout, { type: 'join', panels: grown(panels, page) });
      return '';
    } catch {
      return strings.notJoined;
    }
  }

  /** Joins panels to one. It shows the photo of the first panel, or of a locked one. */
  function joinPanels(panels: readonly number[]) {
    const page = store.page.peek();
    if (!page || cannotJoin(panels) !== '') return;
    const group = grown(panels, page);
    change({ type: 'join', panels: group }, (page) => joined(page, group));
  }

  /** @param follow adapts the panels of the page to the new layout */
  function change(wish: LayoutChange, follow: (page: PageDocument) => PageDocument, gesture?: string) {
    const planner = store.planner.peek();
    const page = store.page.peek();
    if (!planner || !page) return;
    const layout = planner.changeLayout(page.layout, wish, page.page);
    pages.amend({ ...follow(page), layout }, { gesture });
  }
}

/** The page with an open panel after that one, or without that one; merges that lose their sense are parted. */
export function spliced(page: PageDocument, panel: number, by: 1 | -1): PageDocument {
  const panels = [...page.panels];
  if (by > 0) panels.splice(panel + 1, 0, EMPTY);
  else panels.splice(panel, 1);
  // Half of a merged panel, or the remaining panels of a group, may not be adjacent any more.
  return { ...page, panels, merges: otherMerges(page, [panel], (other) => (other > panel ? other + by : other)) };
}

/** Returns the page with one panel in place of the joined ones. Groups that are no longer valid are split. */
export function joined(page: PageDocument, group: readonly number[]): PageDocument {
  const [first] = group;
  const shown = group.filter((panel) => page.panels[panel].photo !== null);
  const stays = shown.find((panel) => page.panels[panel].locked) ?? shown[0] ?? first;
  const left = page.panels.map((_panel, i) => i).filter((panel) => panel === first || !group.includes(panel));
  // The shape of the panel changes, so its crop is computed again.
  const panels = left.map((panel) => (panel === first ? { ...page.panels[stays], edited: false } : page.panels[panel]));
  return { ...page, panels, merges: otherMerges(page, group, (panel) => left.indexOf(panel)) };
}

/** The merges without those panels, where their panels are by then. */
function otherMerges({ merges }: PageDocument, without: readonly number[], moved: (panel: number) => number) {
  return merges.filter((merge) => !merge.some((panel) => without.includes(panel))).map((merge) => merge.map(moved));
}
