/**
 * The insets of the layout as handles over the page, while the layout is edited. An inset is dragged, and its corners change
 * its size. Arrow keys and the tools of the selected inset do both.
 */

import { useRef } from 'preact/hooks';
import { strings } from '../../strings/strings.ts';
import { useApp } from '../../ui/context.ts';
import { place, WAYS } from './panel-shape.ts';
import type { Bounds, Geometry } from '../../engine/types.ts';
import type { OwnKeys } from '../../ui/action.ts';

/** The held part of an inset: all of it, or a corner. -1 is the left or top side, 1 the other one. */
export type Part = 'all' | readonly [-1 | 1, -1 | 1];
type Grip = { id: number; x: number; y: number; bounds: Bounds; part: Part; name: string; moved: boolean };

/** Step of an arrow key in page widths, and with Shift. */
const STEP = 0.01;
const LARGE_STEP = 0.05;
/** Pixels before a press counts as a drag. */
const SLACK = 3;
/** Least side in page widths. The core has a larger minimum. */
const LEAST = 0.01;

const CORNERS = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const;

export const SIZE_KEYS: OwnKeys = {
  keys: ['Alt+ArrowLeft', 'Alt+ArrowUp', 'Alt+ArrowRight', 'Alt+ArrowDown'],
  about: strings.keyAbout.sizeInset,
};

let gestures = 0;

export function Insets({ geometry }: { geometry: Geometry }) {
  const insets = geometry.panels.flatMap(({ overlay }, panel) => (overlay ? [panel] : []));
  if (insets.length === 0) return null;
  return (
    <div class="insets" role="group" aria-label={strings.insets}>
      {insets.map((panel, i) => (
        <Inset key={panel} geometry={geometry} panel={panel} name={strings.inset({ n: i + 1, of: insets.length })} />
      ))}
    </div>
  );
}

function Inset({ geometry, panel, name }: { geometry: Geometry; panel: number; name: string }) {
  const { reshaping, selection, store } = useApp();
  const grip = useRef(null as Grip | null);
  const keys = useRef('');
  const ref = useRef(null as HTMLDivElement | null);
  const shape = geometry.panels[panel];
  const { clipPath: _, ...position } = place(shape, geometry.height);
  const round = shape.circle !== undefined;
  const chosen = selection.panels.value.includes(panel);

  function take(event: PointerEvent, part: Part) {
    if (event.button !== 0) return;
    // The panel below must not be panned.
    event.stopPropagation();
    ref.current?.setPointerCapture(event.pointerId);
    gestures += 1;
    const { clientX: x, clientY: y, pointerId: id } = event;
    grip.current = { id, x, y, bounds: shape.bounds, part, name: `inset-${gestures}`, moved: false };
  }

  function drag(event: PointerEvent) {
    const held = grip.current;
    const page = ref.current?.parentElement;
    if (!held || held.id !== event.pointerId || !page) return;
    event.stopPropagation();
    const [x, y] = [event.clientX - held.x, event.clientY - held.y];
    if (!held.moved && Math.hypot(x, y) < SLACK) return;
    held.moved = true;
    const by = [x / page.clientWidth, y / page.clientWidth] as const;
    reshaping.moveInset(panel, dragged(held.bounds, held.part, by, limits(), round), held.name);
  }

  /** The area inside the margins, in page widths. */
  function limits(): Bounds {
    const margin = store.page.peek()?.page.margin ?? 0;
    return { x: margin, y: margin, width: 1 - 2 * margin, height: geometry.height - 2 * margin };
  }

  function press(event: KeyboardEvent) {
    const way = WAYS[event.key];
    if (!way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = event.shiftKey ? LARGE_STEP : STEP;
    if (keys.current === '') keys.current = `inset-keys-${(gestures += 1)}`;
    const by = [way[0] * step, way[1] * step] as const;
    reshaping.moveInset(panel, dragged(shape.bounds, event.altKey ? [1, 1] : 'all', by, limits(), round), keys.current);
  }

  return (
    <div
      ref={ref}
      class="inset"
      role="button"
      tabIndex={0}
      aria-label={name}
      aria-pressed={chosen}
      aria-description={strings.insetKeys}
      data-round={round}
      style={position}
      onFocus={() => selection.set([panel])}
      onClick={(event) => {
        event.stopPropagation();
        selection.set([panel]);
      }}
      onPointerDown={(event) => take(event, 'all')}
      onPointerMove={drag}
      onPointerUp={() => {
        grip.current = null;
      }}
      onPointerCancel={() => {
        grip.current = null;
      }}
      onKeyDown={press}
      // A held key is one step of the undo.
      onKeyUp={() => {
        keys.current = '';
      }}
    >
      {CORNERS.map(([x, y]) => (
        <span
          key={`${x} ${y}`}
          class="inset-corner"
          data-corner={x === y ? 'falling' : 'rising'}
          style={{ left: x < 0 ? 0 : '100%', top: y < 0 ? 0 : '100%' }}
          onPointerDown={(event) => take(event, [x, y])}
        />
      ))}
    </div>
  );
}

/**
 * The bounds of an inset after a drag. The corner opposite to the dragged one does not move.
 * @param from the bounds at the start of the drag
 * @param by in page widths
 * @param limits that no corner passes
 * @param round whether the inset is a circle, which stays a circle
 */
export function dragged(
  from: Bounds,
  part: Part,
  [x, y]: readonly [number, number],
  limits: Bounds,
  round: boolean,
): Bounds {
  if (part === 'all') return { ...from, x: from.x + x, y: from.y + y };
  const [sideX, sideY] = part;
  const roomX = sideX < 0 ? from.x + from.width - limits.x : limits.x + limits.width - from.x;
  const roomY = sideY < 0 ? from.y + from.height - limits.y : limits.y + limits.height - from.y;
  const sized = (length: number, room: number) => Math.max(LEAST, Math.min(length, room));
  let width = sized(from.width + sideX * x, roomX);
  let height = sized(from.height + sideY * y, roomY);
  if (round) width = height = sized(Math.max(width, height), Math.min(roomX, roomY));
  return {
    x: sideX < 0 ? from.x + from.width - width : from.x,
    y: sideY < 0 ? from.y + from.height - height : from.y,
    width,
    height,
  };
}
