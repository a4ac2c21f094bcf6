/**
 * A photo with its mask over it, and the brush: by a pointer, a finger or a pen, and by the keyboard. The canvas is
 * updated at most once per screen frame.
 */

import { useComputed, useSignalEffect } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { PLAIN } from '../photos/cover.ts';
import { strings } from '../strings/strings.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import type { Point, Retouching } from './retouching.ts';

const WHOLE = { x: 0, y: 0, width: 1, height: 1 };
const ARROWS: Record<string, Point> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};

export function BrushCanvas({ id, name, retouching }: { id: string; name: string; retouching: Retouching }) {
  const { engine } = useApp();
  const area = useRef(null as HTMLDivElement | null);
  const { width, height } = retouching;
  const size = { width, height, crop: WHOLE };
  // The dialog was there before.
  useLayoutEffect(() => area.current?.focus({ preventScroll: true }), []);
  return (
    <div class="brush-room">
      <div
        ref={area}
        class="brush-area"
        role="application"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it is worked on by keys, which an application may be.
        tabIndex={0}
        aria-label={strings.brush.title({ name })}
        aria-describedby="brush-keys"
        data-tool={retouching.tool.value}
        style={{ '--aspect': width / height }}
        onPointerDown={(event: PointerEvent) => begin(event, area.current, retouching)}
        onPointerMove={(event: PointerEvent) => go(event, area.current, retouching)}
        onPointerUp={() => retouching.lift()}
        onPointerCancel={retouching.abandon}
        onKeyDown={(event: KeyboardEvent) => pressed(event, retouching)}
      >
        <Bitmap of={id} draw={(call) => engine.stylePhoto(id, PLAIN, { ...size, tier: 'work' }, call)} />
        <Overlay retouching={retouching} />
        <Ring retouching={retouching} />
      </div>
      <p id="brush-keys" class="brush-keys">
        {strings.brush.keys}
      </p>
    </div>
  );
}

/** The mask, as the engine draws it. */
function Overlay({ retouching }: { retouching: Retouching }) {
  const canvas = useRef(null as HTMLCanvasElement | null);
  const { width, height } = retouching;
  const asked = useRef(0);
  useSignalEffect(() => {
    // Read, to subscribe to the signal.
    retouching.seen.value;
    cancelAnimationFrame(asked.current);
    asked.current = requestAnimationFrame(() => {
      const pixels = retouching.draw(retouching.seen.peek().fine);
      canvas.current?.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
    });
    return () => cancelAnimationFrame(asked.current);
  });
  return <canvas ref={canvas} class="brush-mask" width={width} height={height} aria-hidden="true" />;
}

/** Outline of the brush. */
function Ring({ retouching }: { retouching: Retouching }) {
  const { at, size, tool, width, height } = retouching;
  const style = useComputed(() => {
    const { x, y } = at.value ?? { x: 0.5, y: 0.5 };
    // `choose` selects a subject at a point.
    const radius = tool.value === 'choose' ? 0.012 : size.value;
    const part = (share: number) => `${(100 * share).toFixed(3)}%`;
    const [w, h] = [2 * radius, (2 * radius * width) / height];
    return `left:${part(x - w / 2)};top:${part(y - h / 2)};width:${part(w)};height:${part(h)}`;
  });
  return <span class="brush-ring" style={style} aria-hidden="true" />;
}

function begin(event: PointerEvent, area: HTMLElement | null, retouching: Retouching) {
  // A second finger is ignored.
  if (!area || event.button !== 0 || !event.isPrimary) return;
  // The text of the page would be selected, and the focus is set here.
  event.preventDefault();
  area.focus({ preventScroll: true });
  area.setPointerCapture(event.pointerId);
  retouching.press(pointOf(event, area));
}

function go(event: PointerEvent, area: HTMLElement | null, retouching: Retouching) {
  if (!area || !event.isPrimary) return;
  if (!area.hasPointerCapture(event.pointerId)) {
    retouching.at.value = pointOf(event, area);
    return;
  }
  const all = event.getCoalescedEvents?.() ?? [];
  retouching.strokeTo((all.length > 0 ? all : [event]).map((one) => pointOf(one, area)));
}

/** @returns in parts of the photo */
function pointOf({ clientX, clientY }: { clientX: number; clientY: number }, area: HTMLElement): Point {
  const { left, top, width, height } = area.getBoundingClientRect();
  return { x: (clientX - left) / width, y: (clientY - top) / height };
}

function pressed(event: KeyboardEvent, retouching: Retouching) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const arrow = ARROWS[event.key];
  const deed = arrow ? () => retouching.move(arrow, event.shiftKey) : deedOf(event.key, retouching);
  if (!deed) return;
  event.preventDefault();
  deed();
}

/** @returns the action of a key; undefined for other keys */
function deedOf(key: string, retouching: Retouching): (() => void) | undefined {
  switch (key.toLowerCase()) {
    case ' ':
    case 'enter':
      return retouching.dab;
    case '[':
      return () => retouching.resize(-1);
    case ']':
      return () => retouching.resize(1);
    case 'a':
      return () => void (retouching.tool.value = 'add');
    case 'd':
      return () => void (retouching.tool.value = 'take');
    case 'c':
      return () => void (retouching.tool.value = 'choose');
    case 'n':
      return () => retouching.mend('NextFigure');
    case '+':
    case '=':
      return () => retouching.mend('Grow');
    case '-':
    case '−':
      return () => retouching.mend('Shrink');
    default:
      return undefined;
  }
}
