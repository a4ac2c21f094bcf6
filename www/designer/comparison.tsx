/**
 * A photo or the page in the style, above the original. A draggable divider with keyboard support sets the visible
 * parts.
 */

import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { PLAIN } from '../photos/cover.ts';
import { createPreviewLoop } from './preview-loop.ts';
import { explain } from '../ui/explain.ts';
import type { Designed } from '../engine/design.ts';
import type { Style } from '../engine/types.ts';
import type { Subject } from './preview-subjects.ts';
import type { Signal } from '@preact/signals';

/** Steps of the divider for arrow keys and page keys. */
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

/** @param props `models`: the models of the user in the style; `split`: the unstyled part during a comparison */
export function Comparison({
  subject,
  style,
  models,
  split,
  onStages,
  onBusy,
}: {
  subject: Subject;
  style: Style;
  models: string;
  split: Signal<number> | null;
  onStages: ((designed: Designed) => void) | null;
  onBusy: (busy: boolean) => void;
}) {
  const { messages } = useApp();
  const box = useRef(null as HTMLDivElement | null);
  const styled = useRef(null as HTMLCanvasElement | null);
  const plain = useRef(null as HTMLCanvasElement | null);
  const loop = useRef(null as ReturnType<typeof createPreviewLoop> | null);
  const stages = useRef(onStages);
  stages.current = onStages;
  const { of, name, size } = subject;
  const drawn = useRef(subject);
  drawn.current = subject;

  // Layout effects, so that the preview is busy as soon as its style changes.
  useLayoutEffect(() => {
    const alerts = messages.alertGroup();
    const made = createPreviewLoop({
      draw: (...wish) => drawn.current.draw(...wish),
      drawCards: (...wish) => drawn.current.drawCards(...wish),
      drawWhole: (...wish) => drawn.current.drawWhole(...wish),
      cards: () => stages.current !== null,
      onPicture: ({ bitmap }) => {
        alerts.clear();
        show(styled.current, bitmap);
      },
      onStages: (designed) => stages.current?.(designed),
      onBusy,
      onError: (error) => alerts.report(strings.notDone({ why: explain(error) })),
    });
    loop.current = made;
    return () => {
      made.dispose();
      onBusy(false);
    };
  }, []);

  useLayoutEffect(() => {
    const { clientWidth = 0, clientHeight = 0 } = box.current ?? {};
    const full = Math.min(subject.most, screenPixels(Math.min(clientWidth, (clientHeight * size.width) / size.height)));
    loop.current?.show({ style, ...size, full });
  }, [of, style, models, size.width, size.height]);

  const compared = split !== null;
  useEffect(() => {
    if (!compared) return undefined;
    const stop = new AbortController();
    drawn.current.drawWhole(PLAIN, size, { signal: stop.signal }).then(
      ({ bitmap }) => show(plain.current, bitmap),
      () => {},
    );
    return () => stop.abort();
  }, [of, compared]);

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
      style={{ '--aspect': size.width / size.height, '--split': split?.value ?? 0 }}
      data-compared={compared}
    >
      <canvas ref={plain} class="comparison-plain" aria-hidden="true" hidden={!compared} />
      <canvas ref={styled} class="comparison-styled" role="img" aria-label={name} />
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
