/** The panels of a page in reading order. An inset in the middle is not the last one. */

import type { PageDocument } from '../engine/types.ts';
import type { Planner } from '../document/store.ts';

/** Returns the panels in reading order. It contains the first of merged panels. */
export function readingOrder({ layout, page, panels, merges }: PageDocument, planner: Planner | null): number[] {
  const order = planner?.geometry(layout, page).order ?? panels.map((_, panel) => panel);
  const leads = (panel: number) => merges.every((group) => !group.includes(panel) || group[0] === panel);
  return order.filter((panel) => panel < panels.length && leads(panel));
}
