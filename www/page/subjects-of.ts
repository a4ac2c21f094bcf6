/** What is known of the subjects of a page's photos, for pictures that depend on it. */

import { hasParts } from '../styles/parts.ts';
import { useApp } from '../ui/context.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Store } from '../document/store.ts';

/**
 * @returns a text that changes when the page is to be drawn anew for them; empty where its style draws no part apart. Read while
 * a view is rendered, it renders that again.
 */
export function subjectsOf({ styles, album }: Pick<Store, 'styles' | 'album'>, page: PageDocument | null): string {
  if (!page) return '';
  const style = typeof page.style === 'string' ? styles.peek().find(({ id }) => id === page.style) : page.style;
  if (!hasParts(style)) return '';
  const facts = album.value;
  return page.panels.map(({ photo }) => (photo === null ? '' : (facts.get(photo)?.meta?.mask ?? ''))).join(' ');
}

/** @returns as `subjectsOf` */
export function useSubjectsOf(page: PageDocument | null): string {
  return subjectsOf(useApp().store, page);
}
