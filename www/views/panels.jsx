// @ts-check
/**
 * The panels of the page for keyboard, pointer and screen reader: transparent elements over the canvas, one tab
 * stop for all, arrows move between them by where they are on the page.
 */

import { useRef, useState } from 'preact/hooks';
import { strings } from '../strings.js';
import { useApp } from './context.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').Geometry} Geometry */
/** @typedef {Geometry['panels'][number]} PanelShape */

/** @param {{ page: PageDocument, geometry: Geometry }} props */
export function Panels({ page, geometry }) {
  const { store } = useApp();
  const ref = useRef(/** @type {HTMLDivElement | null} */ (null));
  const [active, setActive] = useState(0);
  const [focused, setFocused] = useState(/** @type {number | null} */ (null));
  const count = Math.min(page.panels.length, geometry.panels.length);
  const stop = Math.min(active, count - 1);

  /** @param {KeyboardEvent} event */
  function onKeyDown(event) {
    const way = WAYS[event.key];
    if (!way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const next = neighbour(geometry.panels, stop, way);
    /** @type {HTMLElement | undefined} */ (ref.current?.children[next])?.focus();
  }

  return (
    <>
      <div class="panels" ref={ref} onKeyDown={onKeyDown} onFocusOut={() => setFocused(null)}>
        {geometry.panels.slice(0, count).map((panel, i) => (
          <div
            key={i}
            class="panel"
            role="group"
            aria-label={strings.panel(i + 1, count)}
            aria-description={store.album.value.get(page.panels[i].photo ?? '')?.name}
            tabIndex={i === stop ? 0 : -1}
            style={place(panel, geometry.height)}
            onFocus={() => {
              setActive(i);
              setFocused(i);
            }}
          />
        ))}
      </div>
      <svg class="panel-ring" viewBox={`0 0 1000 ${geometry.height * 1000}`} aria-hidden="true">
        {focused !== null && geometry.panels[focused] && outline(geometry.panels[focused])}
      </svg>
    </>
  );
}

/** @param {PanelShape} panel */
function outline({ polygon, circle }) {
  if (circle) return <circle cx={circle.x * 1000} cy={circle.y * 1000} r={circle.radius * 1000} />;
  return <polygon points={(polygon ?? []).map(([x, y]) => `${x * 1000},${y * 1000}`).join(' ')} />;
}

/**
 * @param {PanelShape} panel
 * @param {number} height of the page, in its widths
 */
function place({ bounds, polygon, circle }, height) {
  const percent = (/** @type {number} */ part) => `${(part * 100).toFixed(3)}%`;
  const points = (polygon ?? []).map(([x, y]) => (
    `${percent((x - bounds.x) / bounds.width)} ${percent((y - bounds.y) / bounds.height)}`
  ));
  return {
    left: percent(bounds.x),
    top: percent(bounds.y / height),
    width: percent(bounds.width),
    height: percent(bounds.height / height),
    // A slanted panel is hit where it is, not where its box is.
    clipPath: circle ? 'circle(50%)' : `polygon(${points.join(', ')})`,
  };
}

/** @type {Record<string, [number, number]>} */
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * The nearest panel in a direction; sideways distance counts double.
 * @param {PanelShape[]} panels
 * @param {number} from
 * @param {[number, number]} way
 * @returns {number} `from` itself when there is none
 */
export function neighbour(panels, from, [wayX, wayY]) {
  const centre = (/** @type {PanelShape} */ { bounds }) => [bounds.x + bounds.width / 2, bounds.y + bounds.height / 2];
  const [x, y] = centre(panels[from]);
  let best = from;
  let least = Infinity;
  panels.forEach((panel, i) => {
    const [otherX, otherY] = centre(panel);
    const along = (otherX - x) * wayX + (otherY - y) * wayY;
    const across = Math.abs((otherX - x) * wayY) + Math.abs((otherY - y) * wayX);
    const distance = along + 2 * across;
    if (i !== from && along > 1e-6 && distance < least) {
      best = i;
      least = distance;
    }
  });
  return best;
}
