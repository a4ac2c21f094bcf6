/** Subject masks of a page's photos and models of its style, for pictures that depend on them. */

import { modelsOf } from '../painters/references.ts';
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
 * @returns a text that changes when the masks change and the page must be drawn again. It is empty if the style has no
 * part for the subject or the background, and no sound effect is behind a subject. A component that reads it renders
 * again on changes.
 */
export function subjectsOf(store: Pick<Store, 'styles' | 'masks'>, page: PageDocument | null): string {
  if (!page || (!drawsParts(store, page) && frontsOf(page).length === 0)) return '';
  const masks = store.masks.value;
  return page.panels.map(({ photo }) => (photo === null ? '' : (masks.get(photo) ?? ''))).join(' ');
}

/**
 * @returns the mask of the photo behind a text item, or an empty text. A component that reads it renders again on
 * changes.
 */
export function subjectOf({ page, masks }: Pick<Store, 'page' | 'masks'>, { panel }: Word): string {
  const { panels = [], merges = [] } = page.value ?? {};
  const leader = merges.find((group) => group.includes(panel ?? -1))?.[0] ?? panel ?? -1;
  const photo = panels[leader]?.photo;
  return (photo && masks.value.get(photo)) || '';
}

/** @returns as `subjectsOf`, and for the models of its painters */
export function useSubjectsOf(page: PageDocument | null): string {
  const { store, ownPainters } = useApp();
  return [modelsOf(ownPainters.models.value, page?.style), subjectsOf(store, page)].filter(Boolean).join(' ');
}
