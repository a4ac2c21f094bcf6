/**
 * Panels that share one image: which can, and how they are joined and parted again.
 */

import { strings } from '../../strings/strings.ts';
import type { Pages } from '../../document/pages.ts';
import type { Store } from '../../document/store.ts';
import type { PageDocument } from '../../engine/types.ts';
import type { Selection } from './selection.ts';

export type Merging = ReturnType<typeof createMerging>;

export function createMerging({ store, pages, selection }: { store: Store; pages: Pages; selection: Selection }) {
  return { merge, split, cannotMerge, cannotSplit };

  /** @returns why the selected panels cannot be merged; empty if they can */
  function cannotMerge(): string {
    const { merge } = store.obstacles(selection.panels.value) ?? { merge: 'few' };
    return merge ? strings.merging[merge] : '';
  }

  /** @returns the reason why nothing can be split; empty if something can */
  function cannotSplit(): string {
    const page = store.page.value;
    return page && splitting(selection.panels.value, page).length > 0 ? '' : strings.merging.none;
  }

  function merge() {
    const page = store.page.peek();
    const panels = selection.panels.peek();
    if (!page || !pages.edit({ type: 'merge-panels', panels })) return;
    selection.set(grown(panels, page));
  }

  function split() {
    pages.edit({ type: 'split-panels', panels: selection.panels.peek() });
  }
}

/**
 * The given panels, and all panels that already share an image with them.
 * @returns in ascending order
 */
export function grown(panels: readonly number[], { merges }: PageDocument): number[] {
  const groups = merges.filter((group) => group.some((panel) => panels.includes(panel)));
  return [...new Set([...panels, ...groups.flat()])].sort((a, b) => a - b);
}

/** The groups that `Split` divides: groups with a selected panel, or all groups without a selection. */
export function splitting(panels: readonly number[], { merges }: PageDocument) {
  return panels.length === 0 ? merges : merges.filter((group) => group.some((panel) => panels.includes(panel)));
}
