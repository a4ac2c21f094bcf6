/**
 * A photo in the style, over the photo as it is: a divider that is dragged or moved by keys shows how much of each.
 */

import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { PLAIN } from '../photos/cover.ts';
import { createPreviewLoop } from './preview-loop.ts';
import type { Fact } from '../document/album.ts';
import type { Designed } from '../engine/design.ts';
import type { Style } from '../engine/types.ts';
import type { Signal } from '@preact/signals';

/** A live preview has at least so many pixels on its long and its short side. */
const LIVE = { long: 960, short: 540 };
/** The long side of the copy of a photo that is drawn from. */
const WORK = 1600;
/** What the arrow keys and the page keys move the divider by. */
const STEPS: Record<string, number> = {
  ArrowLeft: -0.02,
  ArrowDown: -0.02,
  ArrowRight: 0.02,
  ArrowUp: 0.02,
  PageDown: -0.1,
  PageUp: 0.1,
  Home: -1,
  End: 1,
};

/** @param props `small`: one of several; `split`: the part that shows the photo as it is, while it is compared */
export function Comparison({
  fact: { id, name, meta },
  style,
  small,
  split,
  onStages,
  onBusy,
}: {
  fact: Fact & { meta: NonNullable<Fact['meta']> };
  style: Style;
  small: boolean;
  split: Signal<number> | null;
  onStages: ((designed: Designed) => void) | null;
  onBusy: (busy: boolean) => void;
}) {
  const { engine, messages } = useApp();
  const box = useRef(null as HTMLDivElement | null);
  const styled = useRef(null as HTMLCanvasElement | null);
  const plain = useRef(null as HTMLCanvasElement | null);
  const loop = useRef(null as ReturnType<typeof createPreviewLoop> | null);
  const stages = useRef(onStages);
  stages.current = onStages;
  const size = liveSize(meta, small);

  useEffect(() => {
    const made = createPreviewLoop({
      engine,
      cards: () => stages.current !== null,
      onPicture: ({ bitmap }) => show(styled.current, bitmap),
      onStages: (designed) => {
        show(styled.current, designed.bitmap);
        stages.current?.(designed);
      },
      onBusy,
      onError: ({ message }) => messages.alert(message),
    });
    loop.current = made;
    return () => {
      made.dispose();
      onBusy(false);
    };
  }, []);

  useEffect(() => {
    const most = (WORK / Math.max(WORK, meta.width, meta.height)) * meta.width;
    const full = Math.min(Math.round(most), screenPixels(box.current?.clientWidth ?? 0));
    loop.current?.show({ id, style, ...size, full });
  }, [id, style, size.width, size.height]);

  const compared = split !== null;
  useEffect(() => {
    if (!compared) return undefined;
    const stop = new AbortController();
    engine.stylePhoto(id, PLAIN, { ...size, tier: 'work' }, { signal: stop.signal }).then(
      ({ bitmap }) => show(plain.current, bitmap),
      () => {},
    );
    return () => stop.abort();
  }, [id, compared]);

  function drag(event: PointerEvent) {
    if (!split || !box.current || event.buttons === 0) return;
    const { left, width } = box.current.getBoundingClientRect();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    split.value = inside((event.clientX - left) / width);
  }

  function onKeyDown(event: KeyboardEvent) {
    const step = STEPS[event.key];
    if (!split || step === undefined) return;
    event.preventDefault();
    split.value = inside(split.value + step);
  }

  return (
    <div
      class="comparison"
      ref={box}
      style={{ '--aspect': meta.width / meta.height, '--split': split?.value ?? 0 }}
      data-compared={compared}
    >
      <canvas ref={plain} class="comparison-plain" aria-hidden="true" hidden={!compared} />
      <canvas ref={styled} class="comparison-styled" role="img" aria-label={strings.previewOf(name)} />
      {split && (
        <div class="comparison-hit" onPointerDown={drag} onPointerMove={drag}>
          <div
            class="comparison-divider"
            role="slider"
            tabIndex={0}
            aria-label={strings.divider}
            aria-orientation="horizontal"
            aria-valuemin={0}
            aria-valuemax={100}
            aria-valuenow={Math.round(split.value * 100)}
            aria-valuetext={strings.percent(split.value)}
            onKeyDown={onKeyDown}
          />
        </div>
      )}
    </div>
  );
}

/**
 * Covers 960 x 540, either way up, or half of it for one of several, also where the photo has less: lines are then as
 * fine as on a large one.
 */
function liveSize({ width, height }: { width: number; height: number }, small: boolean) {
  const [long, short] = [Math.max(width, height), Math.min(width, height)];
  const wanted = Math.max(LIVE.long / long, LIVE.short / short) / (small ? 2 : 1);
  const scale = Math.min(wanted, WORK / long);
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}

function inside(part: number) {
  return Math.min(1, Math.max(0, part));
}

function show(canvas: HTMLCanvasElement | null, bitmap: ImageBitmap) {
  if (!canvas) return;
  canvas.width = bitmap.width;
  canvas.height = bitmap.height;
  canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(bitmap);
  // For the benchmark, which counts them.
  canvas.dataset.pictures = String(Number(canvas.dataset.pictures ?? 0) + 1);
}
