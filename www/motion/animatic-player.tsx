/** Preview of an animatic: its images are drawn on time from photos in memory. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { clock } from './clock.ts';
import { clipsOf, closeDrawn, drawFrame, frameAt, framesIn } from './frames.ts';
import type { Planned } from './animatics.ts';
import type { Drawn, DrawnLoop } from './frames.ts';

/** Pixels of the longer side of the preview at most. */
const MOST = 1280;
/** Minimum aspect ratio of the player. Taller videos have borders, because windows are wide. */
const LEAST_ASPECT = 1.2;
/**
 * Number of clips with cached images: both clips of a dissolve, the next one, and some previous ones. Fewer with
 * animated panels.
 */
const KEPT = 6;
const KEPT_LIVING = 2;

export function AnimaticPlayer({ planned }: { planned: Planned | null }) {
  const { animatics } = useApp();
  const canvas = useRef(null as HTMLCanvasElement | null);
  const [playing, setPlaying] = useState(false);
  const [frame, setFrame] = useState(0);
  const at = useRef(0);
  const reel = useRef(null as ReturnType<typeof createReel> | null);
  const count = planned ? framesIn(planned.table) : 0;
  const last = Math.max(0, count - 1);
  const rate = planned?.plan.rate ?? 24;
  const [width, height] = planned?.plan.size ?? [16, 9];

  /** @returns whether all of it was there to be drawn */
  const show = (next: number): boolean => {
    at.current = next;
    setFrame(next);
    return reel.current?.show(next) ?? false;
  };

  useEffect(() => {
    const sheet = canvas.current;
    if (!planned || !sheet) return undefined;
    const shown = sheet.getBoundingClientRect();
    const wide = Math.min(screenPixels(shown.width || 320), Math.round((MOST * width) / Math.max(width, height)));
    const high = Math.max(1, Math.round((wide * height) / width));
    // Resizing a canvas clears it. If only the plan changes, the old picture stays until the new one is ready.
    if (sheet.width !== wide || sheet.height !== high) [sheet.width, sheet.height] = [wide, high];
    const made = createReel(planned, sheet, {
      draw: (clip, signal) => animatics.preview(planned, clip, wide, { signal }),
      enliven: (clip, call) => animatics.previewLoops(planned, clip, call),
    });
    reel.current = made;
    show(Math.min(at.current, framesIn(planned.table) - 1));
    return () => {
      reel.current = null;
      made.dispose();
    };
  }, [planned]);

  useEffect(() => {
    if (!playing || count === 0) return undefined;
    let asked = 0;
    let shownAt = performance.now() - (at.current * 1000) / rate;
    const tick = (now: number) => {
      const next = Math.min(last, Math.floor(((now - shownAt) * rate) / 1000));
      // The clock waits for a picture that is not there yet.
      if (next !== at.current && !show(next)) shownAt = now - (at.current * 1000) / rate;
      if (next >= last) setPlaying(false);
      else asked = requestAnimationFrame(tick);
    };
    asked = requestAnimationFrame(tick);
    return () => cancelAnimationFrame(asked);
  }, [playing, planned]);

  const toggle = () => {
    if (!playing && at.current >= last) show(0);
    setPlaying(!playing);
  };
  const shot =
    planned && count > 0 ? planned.plan.clips[frameAt(planned.table, Math.min(frame, last)).under.clip] : null;
  const told = planned && count > 0 ? frameAt(planned.table, Math.min(frame, last)) : null;
  const [time, of] = [clock(frame / rate), clock(count / rate)];
  const panel = (told?.panel ?? -1) + 1;
  const place = !shot?.reading
    ? strings.animatic.place({ time, of, shot: shot?.number ?? '' })
    : panel > 0
      ? strings.motion.place({ time, of, page: shot.number, panel })
      : strings.motion.placeOfPage({ time, of, page: shot.number });
  return (
    <div
      class="animatic-player"
      role="group"
      aria-label={planned?.plan.clips[0]?.reading ? strings.motion.preview : strings.animatic.preview}
      onKeyDown={(event: KeyboardEvent) => {
        if (event.key !== ' ' || event.target instanceof HTMLButtonElement) return;
        event.preventDefault();
        toggle();
      }}
    >
      <div
        class="animatic-screen"
        style={{ '--aspect': width / height, '--screen': Math.max(LEAST_ASPECT, width / height) }}
      >
        <canvas ref={canvas} role="img" aria-label={place} data-frame={frame} />
      </div>
      <div class="animatic-bar">
        <ActionButton
          action={{
            label: playing ? strings.animatic.pause : strings.animatic.play,
            icon: playing ? 'pause' : 'play',
            enabled: count > 0,
            run: toggle,
          }}
        />
        <input
          type="range"
          aria-label={strings.animatic.position}
          aria-valuetext={place}
          min="0"
          max={last}
          step="1"
          value={frame}
          disabled={count === 0}
          onInput={(event) => {
            setPlaying(false);
            show(Number(event.currentTarget.value));
          }}
        />
        <output aria-hidden="true">
          {clock(frame / rate)} / {clock(count / rate)}
        </output>
      </div>
    </div>
  );
}

/** Draws the pictures of clips on a canvas, on demand. */
function createReel(
  { plan, table }: Planned,
  canvas: HTMLCanvasElement,
  {
    draw,
    enliven,
  }: {
    draw: (clip: number, signal: AbortSignal) => Promise<Drawn>;
    enliven: (clip: number, call: { signal: AbortSignal; onDrawn: (loops: DrawnLoop[]) => void }) => Promise<void>;
  },
) {
  const stop = new AbortController();
  const context = canvas.getContext('2d', { alpha: false });
  const drawn: Map<number, Drawn> = new Map();
  const asked: Set<number> = new Set();
  let current = -1;

  return {
    show,
    dispose() {
      stop.abort();
      for (const one of drawn.values()) closeDrawn(one);
      drawn.clear();
      delete canvas.dataset.moving;
      delete canvas.dataset.shown;
    },
  };

  /** @returns whether its pictures were there */
  function show(frame: number): boolean {
    current = frame;
    const shown = frameAt(table, frame);
    const clips = clipsOf(shown);
    const there = clips.every((clip) => drawn.has(clip));
    for (const clip of clips) ask(clip);
    if (!there || !context) return false;
    drawFrame(context, shown, { drawn: (clip) => drawn.get(clip), captionWidth: canvas.width });
    canvas.dataset.shown = String(frame);
    // The next one is drawn while this one is seen.
    ask(Math.max(...clips) + 1);
    return true;
  }

  function ask(clip: number) {
    const lastClip = frameAt(table, framesIn(table) - 1).under.clip;
    if (drawn.has(clip) || asked.has(clip) || clip > lastClip) return;
    asked.add(clip);
    draw(clip, stop.signal).then(
      (one) => {
        asked.delete(clip);
        if (stop.signal.aborted) return closeDrawn(one);
        drawn.set(clip, one);
        forget();
        if (clipsOf(frameAt(table, current)).includes(clip)) show(current);
        if (plan.living > 0) void move(clip);
      },
      // A photo that cannot be drawn leaves what was there; the file names it.
      () => asked.delete(clip),
    );
  }

  /** Animated panels arrive after the clip. If the clip was released meanwhile, they are dropped. */
  async function move(clip: number) {
    const forgotten = new AbortController();
    const signal = AbortSignal.any([stop.signal, forgotten.signal]);
    const onDrawn = (loops: DrawnLoop[]) => {
      const one = drawn.get(clip);
      if (!one || signal.aborted) {
        forgotten.abort();
        for (const { bitmaps } of loops) for (const bitmap of bitmaps) bitmap.close();
        return;
      }
      one.loops = loops;
      if (clipsOf(frameAt(table, current)).includes(clip)) show(current);
    };
    // A photo that cannot be drawn stays a still. The export reports it.
    await enliven(clip, { signal, onDrawn }).catch(() => {});
    if (!signal.aborted) canvas.dataset.moving = String(drawn.get(clip)?.loops?.length ?? 0);
  }

  /** Frees the cached clips that are farthest from the current one. */
  function forget() {
    const [here] = clipsOf(frameAt(table, current));
    const far = [...drawn.keys()].sort((a, b) => Math.abs(b - here) - Math.abs(a - here));
    const kept = plan.living > 0 ? KEPT_LIVING : KEPT;
    for (const clip of far.slice(0, Math.max(0, drawn.size - kept))) {
      closeDrawn(drawn.get(clip) as Drawn);
      drawn.delete(clip);
    }
  }
}
