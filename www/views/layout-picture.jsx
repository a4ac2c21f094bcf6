// @ts-check
/**
 * A layout as a small drawing: panels as filled shapes whose outlines, in the colour of the paper, are the gutters.
 */

/** @typedef {import('../engine/documents.js').Layout} Layout */
/** @typedef {import('../engine/documents.js').Shape} Shape */

const WIDTH = 60;

/** @param {{ layout: Layout, aspect: number }} props `aspect`: of the page, width over height */
export function LayoutPicture({ layout, aspect }) {
  const height = WIDTH / aspect;
  return (
    <svg class="layout-picture" viewBox={`0 0 ${WIDTH} ${height}`} aria-hidden="true">
      <rect class="layout-paper" width={WIDTH} height={height} />
      {layout.panels.map((panel, i) => drawn(panel.shape, height, i))}
    </svg>
  );
}

/**
 * @param {Shape} shape
 * @param {number} height
 * @param {number} key
 */
function drawn({ polygon, circle }, height, key) {
  if (circle) {
    return <circle key={key} class="layout-panel" cx={circle.x * WIDTH} cy={circle.y * height} r={circle.radius * WIDTH} />;
  }
  const points = (polygon ?? []).map(([x, y]) => `${(x * WIDTH).toFixed(2)},${(y * height).toFixed(2)}`).join(' ');
  return <polygon key={key} class="layout-panel" points={points} />;
}
