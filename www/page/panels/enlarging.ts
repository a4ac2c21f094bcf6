/**
 * A layout with one enlarged panel: the dividers next to it move in small steps, while the other panels retain a
 * reasonable size. An inset grows around its centre.
 */

import { grown } from './merging.ts';
import type { Planner } from '../../engine/core.ts';
import type { Bounds, LayoutChoice, PageDocument } from '../../engine/types.ts';

/** The panel grows to this multiple of its area. */
const GOAL = 1.7;
/** Minimum area of another panel, relative to its area before. */
const FAIR = 0.5;
/** Distance that a cut moves at a time, in parts of its cell. */
const STEP = 0.02;
const MAX_STEPS = 32;
/** Maximum area of an inset, relative to the page, because it covers other panels. */
const MOST_INSET = 0.3;
/** Growth by one step that is worth it, as a part of the area at the start. */
const WORTH = 0.02;

type Measures = Pick<Planner, 'changeLayout' | 'geometry' | 'layoutFacts'>;

/** Returns null if the layout cannot enlarge the panel. */
export function enlarged(planner: Measures, page: PageDocument, panel: number): LayoutChoice | null {
  const { panels, height } = planner.geometry(page.layout, page.page);
  if (panels[panel]?.overlay) {
    const bounds = enlargedInset(panels[panel].bounds, height, page.page.margin);
    return bounds && planner.changeLayout(page.layout, { type: 'move-inset', panel, bounds });
  }
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

/** Returns null if the inset is as large as an inset may be. */
function enlargedInset(from: Bounds, pageHeight: number, margin: number): Bounds | null {
  const area = from.width * from.height;
  const factor = Math.min(
    Math.sqrt(Math.min(GOAL, (MOST_INSET * pageHeight) / area)),
    (1 - 2 * margin) / from.width,
    (pageHeight - 2 * margin) / from.height,
  );
  if (factor * factor < 1 + WORTH) return null;
  const [width, height] = [from.width * factor, from.height * factor];
  const within = (start: number, side: number, all: number) =>
    Math.min(all - margin - side, Math.max(margin, start - side / 2));
  return {
    x: within(from.x + from.width / 2, width, 1),
    y: within(from.y + from.height / 2, height, pageHeight),
    width,
    height,
  };
}

/** The layouts with one divider moved by a step to either side. */
function movesOf(planner: Measures, layout: LayoutChoice, page: PageDocument): LayoutChoice[] {
  const { cuts } = planner.layoutFacts(layout, page.page);
  return cuts.flatMap(({ fraction, slant }, cut) =>
    [-STEP, STEP].map((by) => planner.changeLayout(layout, { type: 'move-cut', cut, fraction: fraction + by, slant })),
  );
}
