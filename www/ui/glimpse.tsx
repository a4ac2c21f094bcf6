/**
 * A large preview of a choice on hover, keyboard focus or long press: the page in that style or layout, or a photo. It
 * is only visual. Escape and any click hide it.
 */

import { useEffect, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { Bitmap, screenPixels } from './bitmap.tsx';
import { useApp } from './context.ts';
import { beside, inside } from './glimpse-place.ts';
import { after } from '../engine/scheduler.ts';
import type { Call } from '../engine/engine.ts';
import type { PageDocument, Style } from '../engine/types.ts';
import type { Point } from './pointing.ts';

type Named = { id: string; name: string };
/** Content of a preview. Another `of` draws another image. */
export type Glimpsed = {
  of: unknown;
  name: string;
  /** Width over height. */
  aspect: number;
  draw: (width: number, call: Call) => Promise<{ bitmap: ImageBitmap }>;
};
/** Position of the preview: over the page, or on the side of the control with the most space. */
type Side = 'page' | 'beside';

/** Milliseconds of rest on a choice before it is drawn, because users who move across a list want to see the list. */
const REST = 220;
/** Keys that choose, and keys that hide a preview. */
const CHOOSES = ['Enter', ' '];
const HIDES = [...CHOOSES, 'Escape'];
/** Minimum movement of a pointer that moves on, in CSS pixels. */
const MOVED = 2;

type Pointed = { id: string; at: DOMRect };
type Position = { x: number; y: number };

/** The last position of the pointer; NaN before it moved. */
let pointer: Position = { x: NaN, y: NaN };
/**
 * Position of the pointer when the user chose something. Elements that then appear under the resting pointer, or get the
 * focus, show nothing. Null after the next movement or key.
 */
let chose: Position | null = null;
watchChoices();

/** Notes choices from the start, because a click may also open the list with the previews. */
function watchChoices() {
  const how = { capture: true, passive: true };
  const choose = () => {
    chose = pointer;
  };
  const onKeyDown = ({ key }: KeyboardEvent) => {
    chose = CHOOSES.includes(key) ? pointer : null;
  };
  const onMove = ({ type, clientX: x, clientY: y }: PointerEvent) => {
    pointer = { x, y };
    if (chose && (type === 'pointerdown' || !(Math.hypot(x - chose.x, y - chose.y) <= MOVED))) chose = null;
  };
  window.addEventListener('click', choose, how);
  window.addEventListener('keydown', onKeyDown, how);
  // The browser also sends `pointerover` for elements that appear under the resting pointer.
  for (const type of ['pointerover', 'pointermove', 'pointerdown'] as const) window.addEventListener(type, onMove, how);
}

/**
 * @param make returns the preview of the choice with that id; null for no preview
 * @param size that it covers at most, in CSS pixels
 */
export function useGlimpse(
  make: (id: string) => Glimpsed | null,
  { side, rest = REST, size = { width: 300, height: 420 } }: { side: Side; rest?: number; size?: Size },
) {
  const [pointed, setPointed] = useState(null as Pointed | null);
  const [glimpsed, setGlimpsed] = useState(null as Glimpsed | null);

  useEffect(() => {
    if (!pointed) {
      setGlimpsed(null);
      return undefined;
    }
    return after(glimpsed ? 0 : rest, () => setGlimpsed(make(pointed.id)));
  }, [pointed?.id]);

  useEffect(() => {
    const stop = new AbortController();
    const how = { capture: true, passive: true, signal: stop.signal };
    const hide = () => setPointed(null);
    window.addEventListener('click', hide, how);
    window.addEventListener('keydown', ({ key }) => HIDES.includes(key) && hide(), how);
    return () => stop.abort();
  }, []);

  const point: Point = (id, element) => {
    if (id === null || !element) setPointed(null);
    else if (chose === null) setPointed({ id, at: element.getBoundingClientRect() });
  };
  return {
    point,
    view: pointed && glimpsed && <Glimpse glimpsed={glimpsed} at={pointed.at} side={side} most={size} />,
  };
}

/** @param make returns the page with the choice of that id; null for no preview */
export function usePageGlimpse(make: (id: string) => PageDocument | null) {
  const { engine } = useApp();
  const nameOf = useNames();
  return useGlimpse(
    (id) => {
      const page = make(id);
      return (
        page && {
          of: page,
          name: nameOf(page),
          aspect: page.page.width / page.page.height,
          draw: (width, call) => engine.renderPage(page, width, call),
        }
      );
    },
    { side: 'page' },
  );
}

type Size = { width: number; height: number };

function Glimpse({
  glimpsed: { of, name, aspect, draw },
  at,
  side,
  most,
}: {
  glimpsed: Glimpsed;
  at: DOMRect;
  side: Side;
  most: Size;
}) {
  const { ui } = useApp();
  const width = Math.min(most.width, most.height * aspect);
  const size = { width, height: width / aspect };
  const whole = { width: innerWidth, height: innerHeight };
  const room = side === 'page' && ui.wide.value ? document.querySelector('.stage') : null;
  // The lists of a narrow window have no side to look past.
  const place = room ? inside(at, size, room.getBoundingClientRect()) : beside(at, size, whole);
  const style = {
    width: `${place.width}px`,
    height: `${place.height}px`,
    insetInlineStart: `${place.left}px`,
    top: `${place.top}px`,
  };
  return (
    <div class="glimpse" style={style} aria-hidden="true">
      <Bitmap of={of} draw={(call) => draw(screenPixels(place.width), call)} />
      <p class="glimpse-name">{name}</p>
    </div>
  );
}

/** Names of the layout and the style of a page. */
function useNames() {
  const { store, ownStyles } = useApp();
  return ({ layout, style }: PageDocument): string => {
    const entry = typeof layout === 'string' ? store.layouts.peek().find(({ id }) => id === layout) : layout;
    const look =
      typeof style === 'string'
        ? (ownStyles.find(style) ?? store.styles.peek().find(({ id }) => id === style))
        : (style as Style);
    return [entry && strings.layoutTitle(entry as Named), look && strings.styleTitle(look)].filter(Boolean).join(' · ');
  };
}
