/**
 * A large preview of a choice on hover, keyboard focus or long press: the page in that style or layout, or a photo. It
 * is there for the eye only, and gone with Escape.
 */

import { useEffect, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { Bitmap, screenPixels } from './bitmap.tsx';
import { useApp } from './context.ts';
import { above, beside, besideList } from './glimpse-place.ts';
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
/** Position of the preview: left of the list, above the strip, or on the side with the most space. */
type Side = 'left' | 'above' | 'beside';

/** Milliseconds that one stays with a choice before it is drawn: who moves across a list wants to see the list. */
const REST = 220;

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
    const timer = setTimeout(() => setGlimpsed(make(pointed.id)), glimpsed ? 0 : rest);
    return () => clearTimeout(timer);
  }, [pointed?.id]);

  useEffect(() => {
    if (!pointed) return undefined;
    const onKeyDown = (event: KeyboardEvent) => event.key === 'Escape' && setPointed(null);
    window.addEventListener('keydown', onKeyDown);
    return () => window.removeEventListener('keydown', onKeyDown);
  }, [pointed !== null]);

  const point: Point = (id, element) =>
    setPointed(id === null || !element ? null : { id, at: element.getBoundingClientRect() });
  return {
    point,
    view: pointed && glimpsed && <Glimpse glimpsed={glimpsed} at={pointed.at} side={side} most={size} />,
  };
}

/** @param make returns the page with the choice of that id; null for no preview */
export function usePageGlimpse(make: (id: string) => PageDocument | null, side: Side = 'left') {
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
    { side },
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
  // The lists of a narrow window have no side to look past.
  const place = !ui.wide.value || side === 'beside' ? beside(at, size, whole) : placed(side, at, size, whole);
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

function placed(side: 'left' | 'above', at: DOMRect, size: Size, whole: Size) {
  return side === 'left' ? besideList(at, size, leftEdge(at), whole) : above(at, size, whole);
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

/** Left edge of the panel with the list, so that the list stays visible. */
function leftEdge(at: DOMRect) {
  const list = document.elementFromPoint(at.left + at.width / 2, at.top + at.height / 2)?.closest('aside');
  return list?.getBoundingClientRect().left ?? at.left;
}
