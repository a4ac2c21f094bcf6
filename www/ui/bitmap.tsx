/**
 * Images that the engine draws when they become visible. The old image is shown until the new one is ready, so nothing
 * flickers. The first image replaces a skeleton.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { Priority } from '../engine/queue.ts';
import { useApp } from './context.ts';
import type { Call } from '../engine/engine.ts';
import type { Lane } from '../engine/scheduler.ts';

/** Thumbnails are requested shortly before they scroll into view. */
const MARGIN = '160px';

type Drawing<T> = { of: unknown; by?: unknown; draw: (call: Call) => Promise<T>; class?: string };

/**
 * A canvas, for single images.
 * @param props `of`: the drawn object, `by`: other dependencies of the image; a change of either draws a new image
 */
export function Bitmap({ of, by, draw, class: extra = '' }: Drawing<{ bitmap: ImageBitmap }>) {
  const ref = useRef(null as HTMLCanvasElement | null);
  const [drawn, setDrawn] = useState(false);
  useDrawn(ref, 'visible', { of, by, draw }, ({ bitmap }, stopped) => {
    const canvas = ref.current;
    if (!canvas || stopped) {
      bitmap.close();
      return;
    }
    canvas.width = bitmap.width;
    canvas.height = bitmap.height;
    canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(bitmap);
    setDrawn(true);
  });
  return <canvas ref={ref} class={`bitmap ${extra}`} data-drawn={drawn} aria-hidden="true" />;
}

/**
 * An image element, for the items of lists. Each canvas is a layer of the compositor, and a hundred layers slow down
 * every frame of the window.
 * @param props as for `Bitmap`; `draw` returns an image file
 */
export function Thumbnail({ of, by, draw, class: extra = '' }: Drawing<Blob>) {
  const ref = useRef(null as HTMLImageElement | null);
  const [drawn, setDrawn] = useState(false);
  useDrawn(ref, 'background', { of, by, draw }, (file, stopped) => {
    const image = ref.current;
    if (!image || stopped) return;
    const address = URL.createObjectURL(file);
    const done = () => {
      URL.revokeObjectURL(address);
      if (image.src === address) setDrawn(image.naturalWidth > 0);
    };
    image.addEventListener('load', done, { once: true });
    image.addEventListener('error', done, { once: true });
    image.src = address;
  });
  return (
    <img
      ref={ref}
      class={`bitmap ${extra}`}
      data-drawn={drawn}
      alt=""
      aria-hidden="true"
      decoding="sync"
      draggable={false}
    />
  );
}

/**
 * Draws an image each time when it becomes visible or changes.
 * @param lane of the scheduler: images of lists wait while the user shuffles
 * @param put receives it, and whether it is outdated
 */
function useDrawn<T>(
  ref: { current: Element | null },
  lane: Lane,
  { of, by, draw }: Drawing<T>,
  put: (image: T, stopped: boolean) => void,
) {
  const { scheduler } = useApp();
  const inView = useInView(ref);
  /** The inputs of the image that is shown, so that an image is drawn once when a list scrolls back and forth. */
  const shown = useRef([] as unknown[]);
  useEffect(() => {
    if (!inView || (shown.current.length > 0 && shown.current[0] === of && shown.current[1] === by)) return undefined;
    const stop = new AbortController();
    const { signal } = stop;
    const drawing = scheduler.turn(lane, { signal }).then(() => draw({ signal, priority: Priority.VIEW }));
    drawing.then(
      (image) => {
        put(image, signal.aborted);
        if (!signal.aborted) shown.current = [of, by];
      },
      // A thumbnail that cannot be drawn stays a skeleton. The page reports errors of photos.
      () => {},
    );
    return () => stop.abort();
  }, [of, by, inView]);
}

export function useInView(ref: { current: Element | null }): boolean {
  const [inView, setInView] = useState(false);
  useEffect(() => {
    const element = ref.current;
    if (!element) return undefined;
    watched.set(element, setInView);
    observer ??= new IntersectionObserver(
      (entries) => entries.forEach(({ target, isIntersecting }) => watched.get(target)?.(isIntersecting)),
      // `scrollMargin` extends the visible area inside scrolling lists, `rootMargin` in the window.
      { rootMargin: MARGIN, scrollMargin: MARGIN } as IntersectionObserverInit,
    );
    observer.observe(element);
    return () => {
      watched.delete(element);
      observer?.unobserve(element);
    };
  }, []);
  return inView;
}

/** One observer for all elements, because each observer takes time in every frame. */
let observer: IntersectionObserver | undefined;
const watched: Map<Element, (inView: boolean) => void> = new Map();

/** @returns the covered screen pixels; more than two per CSS pixel cost time without visible effect */
export function screenPixels(cssPixels: number): number {
  return Math.max(1, Math.round(cssPixels * Math.min(2, globalThis.devicePixelRatio || 1)));
}
