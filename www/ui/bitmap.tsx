/**
 * A canvas that shows what the engine draws for it, once it is in view. What it shows stays until the next picture
 * is there, so nothing flickers; before the first there is a skeleton.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { Priority } from '../engine/queue.ts';
import type { Call } from '../engine/engine.ts';

/** Thumbnails are asked for a little before they scroll into view. */
const MARGIN = '160px';

/** @param props `of`: what is drawn, `by`: what else the picture depends on; another value asks for another picture */
export function Bitmap({
  of,
  by,
  draw,
  class: extra = '',
}: {
  of: unknown;
  by?: unknown;
  draw: (call: Call) => Promise<{ bitmap: ImageBitmap }>;
  class?: string;
}) {
  const ref = useRef(null as HTMLCanvasElement | null);
  const [drawn, setDrawn] = useState(false);
  const inView = useInView(ref);

  useEffect(() => {
    if (!inView) return undefined;
    const stop = new AbortController();
    draw({ signal: stop.signal, priority: Priority.VIEW }).then(
      ({ bitmap }) => {
        const canvas = ref.current;
        if (!canvas || stop.signal.aborted) {
          bitmap.close();
          return;
        }
        canvas.width = bitmap.width;
        canvas.height = bitmap.height;
        canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(bitmap);
        setDrawn(true);
      },
      // A thumbnail that cannot be drawn stays a skeleton; the page itself says what is wrong with a photo.
      () => {},
    );
    return () => stop.abort();
  }, [of, by, inView]);

  return <canvas ref={ref} class={`bitmap ${extra}`} data-drawn={drawn} aria-hidden="true" />;
}

export function useInView(ref: { current: Element | null }): boolean {
  const [inView, setInView] = useState(false);
  useEffect(() => {
    // `scrollMargin` looks ahead inside lists that scroll, `rootMargin` in the window.
    const options = { rootMargin: MARGIN, scrollMargin: MARGIN } as IntersectionObserverInit;
    const observer = new IntersectionObserver(
      (entries) => setInView(entries[entries.length - 1].isIntersecting),
      options,
    );
    if (ref.current) observer.observe(ref.current);
    return () => observer.disconnect();
  }, []);
  return inView;
}

/** @returns the pixels of the screen that they cover; more than two a side cost time that no eye sees */
export function screenPixels(cssPixels: number): number {
  return Math.max(1, Math.round(cssPixels * Math.min(2, globalThis.devicePixelRatio || 1)));
}
