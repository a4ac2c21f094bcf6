/**
 * The panels of the page for keyboard, pointer and screen reader. They are transparent elements over the canvas, with
 * one tab stop for all. Arrows move between them by their position on the page. A click selects a panel, and Shift or
 * Ctrl adds another one. `panel-gestures.ts` and `panel-keys.ts` handle the other input.
 */

import { useRef, useState } from 'preact/hooks';
import { CropGhost } from './crop-ghost.tsx';
import { describePanel } from '../describing.ts';
import { strings } from '../../strings/strings.ts';
import { useApp } from '../../ui/context.ts';
import { target, usePanelGestures, within } from './panel-gestures.ts';
import { PanelMarks } from './panel-marks.tsx';
import { usePanelKeys } from './panel-keys.ts';
import { place } from './panel-shape.ts';
import type { Geometry, PageDocument } from '../../engine/types.ts';

type PanelShape = Geometry['panels'][number];

export function Panels({ page, geometry }: { page: PageDocument; geometry: Geometry }) {
  const { selection, framing } = useApp();
  const ref = useRef(null as HTMLDivElement | null);
  const [active, setActive] = useState(0);
  const [focused, setFocused] = useState(null as number | null);
  const count = Math.min(page.panels.length, geometry.panels.length);
  const stop = Math.min(active, count - 1);
  const chosen = selection.panels.value;
  const describe = useDescription(page);

  const gestures = usePanelGestures();
  const mode = framing.mode.value;
  const onKey = usePanelKeys({
    panels: geometry.panels,
    go: (panel) => (ref.current?.children[panel] as HTMLElement | undefined)?.focus(),
  });

  function leave() {
    setFocused(null);
    if (framing.mode.peek()?.kind === 'frame') framing.mode.value = null;
  }

  function press(event: MouseEvent, panel: number) {
    event.stopPropagation();
    if (gestures.wasDrag()) return;
    const bounds = framing.boundsOf(panel);
    if (framing.placeIn(panel)) selection.set([panel]);
    else if (mode?.kind === 'swap') framing.swapWith(panel);
    else if (mode?.kind === 'focus' && bounds && ref.current) {
      framing.mode.value = null;
      framing.focus(panel, within({ x: event.clientX, y: event.clientY }, ref.current.getBoundingClientRect(), bounds));
    } else {
      framing.mode.value = null;
      selection.press(panel, event.shiftKey || event.ctrlKey || event.metaKey);
    }
  }

  return (
    <>
      <CropGhost page={page} geometry={geometry} />
      <div class="panels" ref={ref} data-mode={framing.placing.value !== null ? 'swap' : mode?.kind} onFocusOut={leave}>
        {geometry.panels.slice(0, count).map((panel, i) => (
          <div
            key={i}
            class="panel"
            role="group"
            aria-label={strings.panel({ n: i + 1, of: count })}
            aria-description={describe(i)}
            tabIndex={i === stop ? 0 : -1}
            style={place(panel, geometry.height)}
            {...gestures.on(i)}
            onClick={(event) => press(event, i)}
            onKeyDown={(event) => onKey(event, i)}
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
        <g class="panel-casing">{chosen.map((i) => geometry.panels[i] && outline(geometry.panels[i], i))}</g>
        {chosen.map((i) => geometry.panels[i] && outline(geometry.panels[i], i))}
        {target.value !== null && geometry.panels[target.value] && (
          <g class="panel-target">{outline(geometry.panels[target.value])}</g>
        )}
      </svg>
      <PanelMarks page={page} geometry={geometry} />
    </>
  );
}

/** The description of a panel in addition to its name: its photo, the content, and whether it is selected. */
function useDescription(page: PageDocument): (panel: number) => string | undefined {
  const { store, selection } = useApp();
  return (panel) => {
    const name = store.album.value.get(page.panels[panel].photo ?? '')?.name;
    const chosen = selection.panels.value.includes(panel) ? strings.chosenPanel : '';
    const locked = page.panels[panel].locked ? strings.lockedPanel : '';
    return (
      [name, describePanel(page, store.album.value, panel), chosen, locked].filter(Boolean).join(', ') || undefined
    );
  };
}

function outline({ polygon, circle }: PanelShape, key?: number) {
  if (circle) return <circle key={key} cx={circle.x * 1000} cy={circle.y * 1000} r={circle.radius * 1000} />;
  return <polygon key={key} points={(polygon ?? []).map(([x, y]) => `${x * 1000},${y * 1000}`).join(' ')} />;
}
