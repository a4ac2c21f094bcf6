/** The enlarged view of a style on the user's photo. Arrow keys go to its neighbours. */

import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { screenPixels } from '../ui/bitmap.tsx';
import { now } from '../ui/action.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { onEscape } from '../ui/on-escape.ts';
import { useStyleDeeds } from './style-deeds.ts';
import { codeOf, explain } from '../ui/explain.ts';
import type { Action } from '../ui/action.ts';
import type { Shown } from '../photos/photo-picker.tsx';
import type { Item, Photo } from './explorer.ts';

/** The long side of the copy of a photo that is drawn from: there is no more to see. */
const MOST = 1600;
/** Steps for arrow keys. */
const STEPS: Record<string, number> = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };
/** Minimum distance of a swipe, in CSS pixels. */
const SWIPE = 48;

export function Enlarged({ fact, photo }: { fact: Shown; photo: Photo }) {
  const { explorer } = useApp();
  const shown = explorer.shown.value;
  const at = shown.findIndex(({ style }) => style.id === explorer.enlarged.value);
  if (at < 0) return null;
  const go = (by: number) => {
    const next = shown[at + by];
    if (next) explorer.enlarged.value = next.style.id;
  };
  return <View fact={fact} photo={photo} item={shown[at]} place={[at, shown.length]} go={go} />;
}

function View({
  fact,
  photo,
  item,
  place: [at, count],
  go,
}: {
  fact: Shown;
  photo: Photo;
  item: Item;
  place: [number, number];
  go: (by: number) => void;
}) {
  const { explorer, ownStyles } = useApp();
  const { style } = item;
  const deeds = useStyleDeeds(style, photo, ownStyles.isFavourite(style.id));
  const ref = useRef(null as HTMLDialogElement | null);
  const last = useRef(style.id);
  last.current = style.id;

  // Set before the next event, so that an immediate key press goes to the view.
  useLayoutEffect(() => {
    const dialog = ref.current;
    dialog?.showModal();
    dialog?.focus();
    return () => {
      dialog?.close();
      // The current tile, not the tile that opened the view.
      const tile = document.querySelector(`[data-style="${CSS.escape(last.current)}"] .wall-picture`);
      (tile as HTMLElement | null)?.focus();
    };
  }, []);

  // At the end of the wall, the focused button is disabled and loses the focus. Then keys would reach the explorer
  // below, and Escape would close both.
  useLayoutEffect(() => {
    if (!ref.current?.contains(document.activeElement)) ref.current?.focus();
  }, [at]);
  useEffect(() => {
    const over = new AbortController();
    onEscape(close, over.signal);
    return () => over.abort();
  }, []);

  function close() {
    explorer.enlarged.value = null;
  }

  /** The result is visible on the wall. */
  function andClose(action: Action): Action {
    return {
      ...action,
      run() {
        action.run();
        close();
      },
    };
  }

  function onKeyDown(event: KeyboardEvent) {
    // Keys do not reach the views below.
    event.stopPropagation();
    const step = STEPS[event.key];
    if (step === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    go(step);
  }

  const points = explorer.scores.shown(item);
  return (
    <dialog
      ref={ref}
      class="enlarged"
      tabIndex={-1}
      aria-label={strings.largeView({ name: style.name })}
      onClose={close}
      onKeyDown={onKeyDown}
      onClick={(event) => event.target === ref.current && close()}
    >
      <header class="enlarged-head">
        <h2>{style.name}</h2>
        {points !== null && <span class="count">{strings.scoreOf({ score: strings.decimal(points, 0) })}</span>}
        <span class="count enlarged-place">{strings.placeOf({ n: at + 1, all: count })}</span>
        <IconButton icon="close" label={strings.close} onClick={close} />
      </header>
      <div class="enlarged-stage">
        <IconButton icon="previous" label={strings.previousStyle} disabled={at === 0} onClick={() => go(-1)} />
        <Picture fact={fact} item={item} go={go} />
        <IconButton icon="next" label={strings.nextStyle} disabled={at === count - 1} onClick={() => go(1)} />
      </div>
      <footer class="enlarged-tools">
        <Tool action={deeds.favour} />
        <Tool action={deeds.edit} />
        <Tool action={andClose(deeds.breed)} />
        <Tool action={andClose(deeds.moreLike)} />
        <ActionButton action={{ ...deeds.use, short: undefined }} class="button strong" text />
      </footer>
    </dialog>
  );
}

/** A tool with its name, or with a short name on small screens. */
function Tool({ action }: { action: Action }) {
  return (
    <ActionButton action={action} class="button tool">
      <Icon name={now(action.icon) ?? ''} />
      <span class="tool-name">{now(action.label)}</span>
      <span class="icon-text" aria-hidden="true">
        {action.short}
      </span>
    </ActionButton>
  );
}

/** Shows the thumbnail at once, then the picture at display size. */
function Picture({ fact: { id, name, meta }, item, go }: { fact: Shown; item: Item; go: (by: number) => void }) {
  const { engine, explorer, messages } = useApp();
  const canvas = useRef(null as HTMLCanvasElement | null);
  const start = useRef(0);
  const { style } = item;

  useEffect(() => {
    const target = canvas.current;
    const frame = target?.parentElement;
    if (!target || !frame) return undefined;
    const paint = (bitmap: ImageBitmap) => {
      target.width = bitmap.width;
      target.height = bitmap.height;
      target.getContext('2d')?.drawImage(bitmap, 0, 0);
    };
    const thumbnail = explorer.pictures.get(style.id);
    if (thumbnail) paint(thumbnail);
    frame.setAttribute('aria-busy', 'true');
    const box = frame.getBoundingClientRect();
    const scale = Math.min(
      screenPixels(box.width) / meta.width,
      screenPixels(box.height) / meta.height,
      MOST / Math.max(meta.width, meta.height),
    );
    const size = {
      width: Math.max(1, Math.round(meta.width * scale)),
      height: Math.max(1, Math.round(meta.height * scale)),
      tier: 'work' as const,
    };
    const stop = new AbortController();
    engine.stylePhoto(id, style, size, { signal: stop.signal }).then(
      ({ bitmap }) => {
        if (!stop.signal.aborted) {
          paint(bitmap);
          frame.setAttribute('aria-busy', 'false');
        }
        bitmap.close();
      },
      (error) => {
        if (codeOf(error) !== 'cancelled') messages.alert(strings.notDone({ why: explain(error) }));
      },
    );
    return () => stop.abort();
  }, [style.id, id]);

  return (
    <div
      class="enlarged-picture"
      style={{ '--aspect': meta.width / meta.height }}
      onPointerDown={(event) => {
        start.current = event.clientX;
      }}
      onPointerUp={({ pointerType, clientX }) => {
        const by = clientX - start.current;
        if (pointerType === 'touch' && Math.abs(by) > SWIPE) go(by < 0 ? 1 : -1);
      }}
    >
      <canvas ref={canvas} role="img" aria-label={strings.styleOn({ style: style.name, photo: name })} />
    </div>
  );
}
