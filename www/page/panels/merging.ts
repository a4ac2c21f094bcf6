/**
 * Panels that share one image: which can, and how they are joined and parted again.
 */

import { strings } from '../../strings/strings.ts';
import type { Pages } from '../../document/pages.ts';
import type { Store } from '../../document/store.ts';
import type { LayoutFacts, PageDocument } from '../../engine/types.ts';
import type { Selection } from './selection.ts';

export type Merging = ReturnType<typeof createMerging>;

export function createMerging({ store, pages, selection }: { store: Store; pages: Pages; selection: Selection }) {
  return { merge, split, cannotMerge, cannotSplit };

  /** @returns why the chosen panels cannot be merged; empty when they can */
  function cannotMerge(): string {
    const page = store.page.value;
    const facts = store.layoutFacts.value;
    return page && facts ? whyNotMerge(selection.panels.value, page, facts) : strings.merging.few;
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

/** @returns a reason, or an empty text if they can be merged */
export function whyNotMerge(panels: readonly number[], page: PageDocument, { base, adjacent }: LayoutFacts): string {
  if (panels.length < 2) return strings.merging.few;
  if (panels.some((panel) => panel >= base)) return strings.merging.overlay;
  const group = grown(panels, page);
  if (page.merges.some((other) => other.length === group.length && other.includes(group[0])))
    return strings.merging.already;
  const reached = [group[0]];
  // The list grows while it is walked.
  for (const from of reached) {
    const beside = adjacent.flatMap(([a, b]) => (a === from ? [b] : b === from ? [a] : []));
    reached.push(...beside.filter((to) => group.includes(to) && !reached.includes(to)));
  }
  return reached.length === group.length ? '' : strings.merging.apart;
}

/** The groups that `Split` divides: groups with a selected panel, or all groups without a selection. */
export function splitting(panels: readonly number[], { merges }: PageDocument) {
  return panels.length === 0 ? merges : merges.filter((group) => group.some((panel) => panels.includes(panel)));
}
