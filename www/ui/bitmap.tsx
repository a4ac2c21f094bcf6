/**
 * A canvas that the engine draws when it becomes visible. The old image is shown until the new one is ready, so nothing
 * flickers. The first image replaces a skeleton.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { Priority } from '../engine/queue.ts';
import type { Call } from '../engine/engine.ts';

/** Thumbnails are requested shortly before they scroll into view. */
const MARGIN = '160px';

/** @param props `of`: the drawn object, `by`: other dependencies of the image; a change of either draws a new image */
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
      // A thumbnail that cannot be drawn stays a skeleton. The page reports errors of photos.
      () => {},
    );
    return () => stop.abort();
  }, [of, by, inView]);

  return <canvas ref={ref} class={`bitmap ${extra}`} data-drawn={drawn} aria-hidden="true" />;
}

export function useInView(ref: { current: Element | null }): boolean {
  const [inView, setInView] = useState(false);
  useEffect(() => {
    // `scrollMargin` extends the visible area inside scrolling lists, `rootMargin` in the window.
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

/** @returns the covered screen pixels; more than two per CSS pixel cost time without visible effect */
export function screenPixels(cssPixels: number): number {
  return Math.max(1, Math.round(cssPixels * Math.min(2, globalThis.devicePixelRatio || 1)));
}
