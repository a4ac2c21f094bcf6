/**
 * A large preview of a choice on hover, keyboard focus or long press: the page in that style or layout, or a photo. It
 * is only visual. Escape and any click hide it.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
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
/** Keys that choose. */
const CHOOSES = ['Enter', ' '];
/** Minimum movement of a pointer that moves on, in CSS pixels. */
const MOVED = 2;

type Pointed = { id: string; at: DOMRect };

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

  /** The last position of the pointer; NaN before it moved. */
  const pointer = useRef({ x: NaN, y: NaN });
  /**
   * Position of the pointer when the user chose something. Elements that then appear under the resting pointer, or get
   * the focus, show nothing. Null after the next movement or key.
   */
  const chose = useRef(null as { x: number; y: number } | null);
  useEffect(() => {
    const stop = new AbortController();
    const how = { capture: true, passive: true, signal: stop.signal };
    const choose = () => {
      chose.current = pointer.current;
      setPointed(null);
    };
    const onKeyDown = ({ key }: KeyboardEvent) => {
      chose.current = null;
      if (CHOOSES.includes(key)) choose();
      else if (key === 'Escape') setPointed(null);
    };
    const onMove = ({ type, clientX: x, clientY: y }: PointerEvent) => {
      pointer.current = { x, y };
      const from = chose.current;
      if (from && (type === 'pointerdown' || !(Math.hypot(x - from.x, y - from.y) <= MOVED))) chose.current = null;
    };
    window.addEventListener('click', choose, how);
    window.addEventListener('keydown', onKeyDown, how);
    // The browser also sends `pointerover` for elements that appear under the resting pointer.
    for (const type of ['pointerover', 'pointermove', 'pointerdown'] as const)
      window.addEventListener(type, onMove, how);
    return () => stop.abort();
  }, []);

  const point: Point = (id, element) => {
    if (id === null || !element) setPointed(null);
    else if (chose.current === null) setPointed({ id, at: element.getBoundingClientRect() });
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
