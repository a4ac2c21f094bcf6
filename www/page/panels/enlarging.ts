/**
 * A layout with one enlarged panel: the dividers next to it move in small steps, while the other panels retain a
 * reasonable size.
 */

import { grown } from './merging.ts';
import type { Planner } from '../../engine/core.ts';
import type { LayoutChoice, PageDocument } from '../../engine/types.ts';

/** The panel grows to this multiple of its area. */
const GOAL = 1.7;
/** Minimum area of another panel, relative to its area before. */
const FAIR = 0.4;
/** Distance that a cut moves at a time, in parts of its cell. */
const STEP = 0.04;
const MAX_STEPS = 16;
/** Growth by one step that is worth it, as a part of the area at the start. */
const WORTH = 0.02;

type Measures = Pick<Planner, 'changeLayout' | 'geometry' | 'layoutFacts'>;

/** Returns null if no cut enlarges the panel. */
export function enlarged(planner: Measures, page: PageDocument, panel: number): LayoutChoice | null {
  const group = grown([panel], page);
  const areas = (layout: LayoutChoice) =>
    planner.geometry(layout, page.page).panels.map(({ bounds }) => bounds.width * bounds.height);
  const start = areas(page.layout);
  const size = (of: readonly number[]) => group.reduce((sum, i) => sum + of[i], 0);
  const isFair = (of: readonly number[]) =>
    of.every((area, i) => {
      if (group.includes(i)) return true;
      return page.panels[i]?.locked ? Math.abs(area - start[i]) < 1e-6 : area >= FAIR * start[i];
    });

  let layout = page.layout;
  let reached = size(start);
  for (let step = 0; step < MAX_STEPS && reached < GOAL * size(start); step += 1) {
    const moves = movesOf(planner, layout, page)
      .map((to) => ({ to, of: areas(to) }))
      .filter(({ of }) => isFair(of) && size(of) > reached + WORTH * size(start))
      .sort((a, b) => size(b.of) - size(a.of));
    if (moves.length === 0) break;
    layout = moves[0].to;
    reached = size(moves[0].of);
  }
  return layout === page.layout ? null : layout;
}

/** The layouts with one divider moved by a step to either side. */
function movesOf(planner: Measures, layout: LayoutChoice, page: PageDocument): LayoutChoice[] {
  const { cuts } = planner.layoutFacts(layout, page.page);
  return cuts.flatMap(({ fraction, slant }, cut) =>
    [-STEP, STEP].map((by) => planner.changeLayout(layout, { type: 'move-cut', cut, fraction: fraction + by, slant })),
  );
}
