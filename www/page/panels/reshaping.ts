/**
 * Manual changes of the layout: a generated layout, a moved divider or inset, a split or removed panel, joined panels. The
 * page then stores the complete layout, like any other page.
 */

import { signal } from '@preact/signals';
import { strings } from '../../strings/strings.ts';
import type { Pages } from '../../document/pages.ts';
import type { Store } from '../../document/store.ts';
import type { Bounds, LayoutChange } from '../../engine/types.ts';
import type { Signal } from '@preact/signals';

export type Reshaping = ReturnType<typeof createReshaping>;

/** Number of panels of a generated layout, if the user did not choose one. */
const USUAL = { least: 3, most: 8 };

export function createReshaping({ store, pages, seed }: { store: Store; pages: Pages; seed: () => number }) {
  return {
    /** Whether the cuts show their handles. */
    editing: signal(false),
    /** Whether a cut is dragged. */
    dragging: signal(false),
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
    change({ type: 'move-cut', cut, ...to }, gesture);
  }

  /**
   * @param bounds in page widths
   * @param gesture names the drag, which is one step of the undo
   */
  function moveInset(panel: number, bounds: Bounds, gesture: string) {
    change({ type: 'move-inset', panel, bounds }, gesture);
  }

  function splitPanel(panel: number, axis: 'rows' | 'columns') {
    change({ type: 'split', panel, axis });
  }

  function removePanel(panel: number) {
    change({ type: 'remove', panel });
  }

  /** @returns why those panels cannot become one; empty when they can */
  function cannotJoin(panels: readonly number[]): string {
    const { join } = store.obstacles(panels) ?? { join: 'few' };
    return join ? strings.merging[join] : '';
  }

  /** Joins panels to one. It shows the photo of the first panel, or of a locked one. */
  function joinPanels(panels: readonly number[]) {
    if (cannotJoin(panels) === '') change({ type: 'join', panels });
  }

  function change(change: LayoutChange, gesture?: string) {
    pages.edit({ type: 'reshape', change, gesture });
  }
}
