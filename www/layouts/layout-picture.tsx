/** The panels of a layout as a small drawing; the option around it is the sheet of paper. */

import type { LayoutEntry } from '../engine/types.ts';

/** Width of the drawing; the core's paths are made for it. */
const WIDTH = 1000;

/** @param props `aspect`: of the page, width over height */
export function LayoutPicture({
  layout: { base, over },
  aspect,
}: {
  layout: Pick<LayoutEntry, 'base' | 'over'>;
  aspect: number;
}) {
  const height = WIDTH / aspect;
  return (
    <svg class="layout-picture" viewBox={`0 0 ${WIDTH} ${Math.round(height)}`} aria-hidden="true">
      <path class="layout-panel" d={base} />
      {over && <path class="layout-panel over" d={over} />}
    </svg>
  );
}
