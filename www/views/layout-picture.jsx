// @ts-check
/** A layout as a small drawing: its panels on a sheet of paper of the page's shape. */

/** Width of the drawing; the core's paths are made for it. */
const WIDTH = 100;

/** @param {{ layout: Pick<import('../engine/documents.js').LayoutEntry, 'base' | 'over'>, aspect: number }} props `aspect`: of the page, width over height */
export function LayoutPicture({ layout: { base, over }, aspect }) {
  const height = WIDTH / aspect;
  return (
    <svg class="layout-picture" viewBox={`0 0 ${WIDTH} ${height.toFixed(1)}`} aria-hidden="true">
      <rect class="layout-paper" width={WIDTH} height={height} />
      <path class="layout-panel" d={base} />
      {over && <path class="layout-panel over" d={over} />}
    </svg>
  );
}
