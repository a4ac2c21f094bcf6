/** What is known of the subjects of a page's photos, for pictures that depend on it. */

import { hasParts } from '../styles/parts.ts';
import { frontsOf } from '../engine/figures.ts';
import { useApp } from '../ui/context.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { Store } from '../document/store.ts';

/** @returns whether the style of a page draws the subjects of its photos apart */
export function drawsParts({ styles }: Pick<Store, 'styles'>, { style }: PageDocument): boolean {
  return hasParts(typeof style === 'string' ? styles.peek().find(({ id }) => id === style) : style);
}

/**
 * @returns a text that changes when the page is to be drawn anew for them; empty where its style draws no part apart, and no effect
 * stands behind one. Read while a view is rendered, it renders that again.
 */
export function subjectsOf(store: Pick<Store, 'styles' | 'masks'>, page: PageDocument | null): string {
  if (!page || (!drawsParts(store, page) && frontsOf(page).length === 0)) return '';
  const masks = store.masks.value;
  return page.panels.map(({ photo }) => (photo === null ? '' : (masks.get(photo) ?? ''))).join(' ');
}

/** @returns the mask of the photo that a word stands on; empty where there is none. Read while a view is rendered, it renders that again */
export function subjectOf({ page, masks }: Pick<Store, 'page' | 'masks'>, { panel }: Word): string {
  const { panels = [], merges = [] } = page.value ?? {};
  const leader = merges.find((group) => group.includes(panel ?? -1))?.[0] ?? panel ?? -1;
  const photo = panels[leader]?.photo;
  return (photo && masks.value.get(photo)) || '';
}

/** @returns as `subjectsOf` */
export function useSubjectsOf(page: PageDocument | null): string {
  return subjectsOf(useApp().store, page);
}
