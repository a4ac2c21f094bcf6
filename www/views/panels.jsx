// @ts-check
/**
 * The panels of the page for keyboard, pointer and screen reader: transparent elements over the canvas, one tab
 * stop for all, arrows move between them by where they are on the page. A click chooses a panel, with Shift or Ctrl
 * one more.
 */

import { useRef, useState } from 'preact/hooks';
import { strings } from '../strings.js';
import { useApp } from './context.js';
import { WAYS, neighbour, place } from './panel-shape.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').Geometry} Geometry */
/** @typedef {Geometry['panels'][number]} PanelShape */

/** @param {{ page: PageDocument, geometry: Geometry }} props */
export function Panels({ page, geometry }) {
  const { selection } = useApp();
  const ref = useRef(/** @type {HTMLDivElement | null} */ (null));
  const [active, setActive] = useState(0);
  const [focused, setFocused] = useState(/** @type {number | null} */ (null));
  const count = Math.min(page.panels.length, geometry.panels.length);
  const stop = Math.min(active, count - 1);
  const chosen = selection.panels.value;
  const describe = useDescription(page);

  /** @param {KeyboardEvent} event */
  function onKeyDown(event) {
    const way = WAYS[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (way) {
      const next = neighbour(geometry.panels, stop, way);
      /** @type {HTMLElement | undefined} */ (ref.current?.children[next])?.focus();
    } else if (event.key === 'Enter' && (event.shiftKey || selection.several.value)) {
      selection.toggle(stop);
    } else if (event.key === ' ' && selection.several.value) {
      selection.toggle(stop);
    } else {
      return;
    }
    event.preventDefault();
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
            aria-description={describe(i)}
            tabIndex={i === stop ? 0 : -1}
            style={place(panel, geometry.height)}
            onClick={(event) => {
              event.stopPropagation();
              selection.press(i, event.shiftKey || event.ctrlKey || event.metaKey);
            }}
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
      <svg class="panel-choice" viewBox={`0 0 1000 ${geometry.height * 1000}`} aria-hidden="true">
        {chosen.map((i) => geometry.panels[i] && outline(geometry.panels[i], i))}
      </svg>
    </>
  );
}

/**
 * What is said of a panel beside its name: its photo, and whether it is chosen.
 * @param {PageDocument} page
 * @returns {(panel: number) => string | undefined}
 */
function useDescription(page) {
  const { store, selection } = useApp();
  return (panel) => {
    const name = store.album.value.get(page.panels[panel].photo ?? '')?.name;
    return selection.panels.value.includes(panel) ? strings.chosenPanel(name ?? '') : name;
  };
}

/**
 * @param {PanelShape} panel
 * @param {number} [key]
 */
function outline({ polygon, circle }, key) {
  if (circle) return <circle key={key} cx={circle.x * 1000} cy={circle.y * 1000} r={circle.radius * 1000} />;
  return <polygon key={key} points={(polygon ?? []).map(([x, y]) => `${x * 1000},${y * 1000}`).join(' ')} />;
}
