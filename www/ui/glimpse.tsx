/**
 * What a choice would make of the page, seen while one points at it or has the focus on it: the whole page in that style or
 * layout, beside the list. It is there for the eye only, and gone with Escape.
 */

import { useEffect, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { Bitmap, screenPixels } from './bitmap.tsx';
import { useApp } from './context.ts';
import type { PageDocument, Style } from '../engine/types.ts';

type Named = { id: string; name: string };

/** Milliseconds that one stays with a choice before it is drawn: who moves across a list wants to see the list. */
const REST = 220;
/** Between it and what it belongs to, and from the edges of the window, in CSS pixels. */
const GAP = 12;
const WIDTH = 300;
const HEIGHT = 420;

type Pointed = { id: string; at: DOMRect };
/** Tells what is pointed at, and null when nothing is any more. */
export type Point = (id: string | null, element?: Element) => void;

/**
 * @param make the page with the choice of that id; null for none
 * @param side where there is room for it
 */
export function useGlimpse(make: (id: string) => PageDocument | null, side: 'left' | 'above' = 'left') {
  const { ui } = useApp();
  const [pointed, setPointed] = useState(null as Pointed | null);
  const [page, setPage] = useState(null as PageDocument | null);

  useEffect(() => {
    if (!pointed) {
      setPage(null);
      return undefined;
    }
    const rest = setTimeout(() => setPage(make(pointed.id)), page ? 0 : REST);
    return () => clearTimeout(rest);
  }, [pointed?.id]);

  useEffect(() => {
    if (!pointed) return undefined;
    const onKeyDown = (event: KeyboardEvent) => event.key === 'Escape' && setPointed(null);
    window.addEventListener('keydown', onKeyDown);
    return () => window.removeEventListener('keydown', onKeyDown);
  }, [pointed !== null]);

  const point: Point = (id, element) =>
    setPointed(id === null || !element || !ui.wide.peek() ? null : { id, at: element.getBoundingClientRect() });
  return { point, view: pointed && page && <Glimpse page={page} at={pointed.at} side={side} /> };
}

function Glimpse({ page, at, side }: { page: PageDocument; at: DOMRect; side: 'left' | 'above' }) {
  const { engine } = useApp();
  const aspect = page.page.width / page.page.height;
  const width = Math.min(WIDTH, HEIGHT * aspect);
  const height = width / aspect;
  const within = (place: number, size: number, whole: number) => Math.max(GAP, Math.min(place, whole - size - GAP));
  const place =
    side === 'left'
      ? {
          insetInlineStart: `${leftEdge(at) - width - GAP}px`,
          top: `${within(at.top + at.height / 2 - height / 2, height, innerHeight)}px`,
        }
      : {
          insetInlineStart: `${within(at.left + at.width / 2 - width / 2, width, innerWidth)}px`,
          top: `${Math.max(GAP, at.top - height - GAP)}px`,
        };
  const style = { width: `${width}px`, height: `${height}px`, ...place };
  return (
    <div class="glimpse" style={style} aria-hidden="true">
      <Bitmap of={page} draw={(call) => engine.renderPage(page, screenPixels(width), call)} />
      <p class="glimpse-name">{useName(page)}</p>
    </div>
  );
}

/** What its layout and its style are called. */
function useName({ layout, style }: PageDocument): string {
  const { store, ownStyles } = useApp();
  const entry = typeof layout === 'string' ? store.layouts.value.find(({ id }) => id === layout) : layout;
  const look =
    typeof style === 'string'
      ? (ownStyles.find(style) ?? store.styles.value.find(({ id }) => id === style))
      : (style as Style);
  return [entry && strings.layoutTitle(entry as Named), look && strings.styleTitle(look)].filter(Boolean).join(' · ');
}

/** Of the side that the list is in, so that nothing of the list is hidden. */
function leftEdge(at: DOMRect) {
  const list = document.elementFromPoint(at.left + at.width / 2, at.top + at.height / 2)?.closest('aside');
  return list?.getBoundingClientRect().left ?? at.left;
}
