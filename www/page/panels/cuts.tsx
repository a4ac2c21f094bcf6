/**
 * The cuts of the layout as handles over the page: a cut is dragged, its ends slant it, arrows do both, and so do the
 * tools of the cut that is chosen. While the layout is not edited, a mouse drags the gutters.
 */

import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../../strings/strings.ts';
import { useApp } from '../../ui/context.ts';
import type { Cut } from '../../engine/types.ts';
import type { OwnKeys } from '../../ui/action.ts';

/** which part of a cut is held */
type End = 'both' | 'from' | 'to';
type Grip = { id: number; x: number; y: number; cut: Cut; end: End; name: string };

/** Step of an arrow key when it moves a divider, and with Shift. */
const STEP = 0.01;
const LARGE_STEP = 0.05;

export function Cuts() {
  const { store } = useApp();
  const cuts = useCuts();
  const geometry = store.geometry.value;
  const hasInsets = geometry?.panels.some(({ overlay }) => overlay) ?? false;
  return (
    <div class="cuts" role="group" aria-label={strings.cuts}>
      {cuts.map((cut, i) => (
        <CutHandle key={i} cut={cut} index={i} count={cuts.length} />
      ))}
      {cuts.length === 0 && !hasInsets && <p class="cuts-none">{strings.noCuts}</p>}
    </div>
  );
}

/** The gutters below the panels. Keyboards and fingers use `Edit layout`, which has larger handles. */
export function Gutters() {
  const cuts = useCuts();
  return (
    <div class="cuts" aria-hidden="true">
      {cuts.map((cut, i) => (
        <Gutter key={i} cut={cut} index={i} />
      ))}
    </div>
  );
}

/** The cuts as the page shows them. */
function useCuts(): readonly Cut[] {
  const { store } = useApp();
  const found = store.layoutFacts.value?.cuts ?? [];
  return store.page.value?.page.rtl ? found.map((cut) => ({ ...cut, ...mirrored(cut), ...mirroredEnds(cut) })) : found;
}

let gestures = 0;

type Slant = Pick<Cut, 'fraction' | 'slant'>;

/** A cut of a mirrored page, or back. */
function mirrored<S extends Slant & Pick<Cut, 'axis'>>({ axis, fraction, slant }: S): Slant {
  return { fraction: axis === 'columns' ? 1 - fraction : fraction, slant: -slant };
}

function mirroredEnds({ axis, from, to }: Cut): Pick<Cut, 'from' | 'to'> {
  const ends = [from, to].map(([x, y]): [number, number] => [1 - x, y]);
  const [first, last] = axis === 'rows' ? ends.reverse() : ends;
  return { from: first, to: last };
}

/** Moves a cut with the pointer. */
function useCutDrag(cut: Cut, index: number) {
  const { store, reshaping } = useApp();
  const rtl = store.page.value?.page.rtl ?? false;
  const move = (to: Slant, gesture: string) =>
    reshaping.moveCut(index, rtl ? mirrored({ axis: cut.axis, ...to }) : to, gesture);
  const grip = useRef(null as Grip | null);
  const ref = useRef(null as HTMLDivElement | null);

  function take(event: PointerEvent, end: End) {
    if (event.button !== 0) return;
    // The page below must neither be panned nor turned.
    event.stopPropagation();
    ref.current?.setPointerCapture(event.pointerId);
    gestures += 1;
    grip.current = { id: event.pointerId, x: event.clientX, y: event.clientY, cut, end, name: `cut-${gestures}` };
    reshaping.dragging.value = true;
  }

  function drag(event: PointerEvent) {
    const held = grip.current;
    const page = ref.current?.parentElement;
    if (!held || held.id !== event.pointerId || !page) return;
    event.stopPropagation();
    const moved = held.cut.axis === 'rows' ? event.clientY - held.y : event.clientX - held.x;
    move(shifted(held.cut, held.end, moved / page.clientWidth / held.cut.length), held.name);
  }

  function release() {
    grip.current = null;
    reshaping.dragging.value = false;
  }

  // Shuffle and undo can remove the divider during the drag.
  useEffect(
    () => () => {
      if (grip.current) release();
    },
    [],
  );

  const on = { onPointerMove: drag, onPointerUp: release, onPointerCancel: release };
  return { ref, move, take, on };
}

/** The place of a cut on the page. */
function useCutPlace({ from: [x1, y1], to: [x2, y2] }: Cut) {
  const height = useApp().store.geometry.value?.height ?? 1;
  return {
    left: `${(x1 + x2) * 50}%`,
    top: `${((y1 + y2) * 50) / height}%`,
    width: `${Math.hypot(x2 - x1, y2 - y1) * 100}%`,
    rotate: `${Math.atan2(y2 - y1, x2 - x1)}rad`,
  };
}

function Gutter({ cut, index }: { cut: Cut; index: number }) {
  const { ref, take, on } = useCutDrag(cut, index);
  return (
    <div
      ref={ref}
      class="cut gutter"
      data-axis={cut.axis}
      style={useCutPlace(cut)}
      onPointerDown={(event) => take(event, 'both')}
      {...on}
    />
  );
}

function CutHandle({ cut, index, count }: { cut: Cut; index: number; count: number }) {
  const { reshaping } = useApp();
  const { ref, move, take, on } = useCutDrag(cut, index);
  const keys = useRef('');

  function press(event: KeyboardEvent) {
    const way = wayOf(event.key, cut.axis, event.altKey);
    if (way === 0 || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = way * (event.shiftKey ? LARGE_STEP : STEP);
    if (keys.current === '') keys.current = `cut-keys-${(gestures += 1)}`;
    const { fraction, slant } = cut;
    move(event.altKey ? { fraction, slant: slant + 2 * step } : { fraction: fraction + step, slant }, keys.current);
  }

  return (
    <div
      ref={ref}
      class="cut"
      role="slider"
      tabIndex={0}
      aria-label={strings.cut({ n: index + 1, of: count })}
      aria-orientation={cut.axis === 'rows' ? 'vertical' : 'horizontal'}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(cut.fraction * 100)}
      aria-valuetext={whereIs(cut)}
      aria-description={strings.cutKeys}
      data-axis={cut.axis}
      data-chosen={reshaping.cut.value === index}
      style={useCutPlace(cut)}
      onFocus={() => {
        reshaping.cut.value = index;
      }}
      onPointerDown={(event) => take(event, 'both')}
      {...on}
      onKeyDown={press}
      // A held key is one step of the undo.
      onKeyUp={() => {
        keys.current = '';
      }}
    >
      <span class="cut-end" onPointerDown={(event) => take(event, 'from')} />
      <span class="cut-grip" />
      <span class="cut-end" onPointerDown={(event) => take(event, 'to')} />
    </div>
  );
}

export const SLANT_KEYS: OwnKeys = { keys: ['Alt+ArrowUp', 'Alt+ArrowDown'], about: strings.keyAbout.slant };

/**
 * @param cut its state at the start of the drag
 * @param by parts of its cell
 */
export function shifted({ fraction, slant }: Cut, end: End, by: number): { fraction: number; slant: number } {
  if (end === 'both') return { fraction: fraction + by, slant };
  return { fraction: fraction + by / 2, slant: slant + (end === 'to' ? by : -by) };
}

/** @returns `50%, slanted by 2%` */
function whereIs({ fraction, slant }: Cut) {
  const at = strings.percent(fraction);
  return Math.abs(slant) < 0.005 ? at : strings.cutSlanted({ at, slant: strings.percent(slant) });
}

function wayOf(key: string, axis: Cut['axis'], slants: boolean): -1 | 0 | 1 {
  const [less, more] = axis === 'rows' ? ['ArrowUp', 'ArrowDown'] : ['ArrowLeft', 'ArrowRight'];
  if (key === more || (slants && (key === 'ArrowRight' || key === 'ArrowDown'))) return 1;
  if (key === less || (slants && (key === 'ArrowLeft' || key === 'ArrowUp'))) return -1;
  return 0;
}
