/** The photo tray: photos in use, and excluded photos with the reason. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { isUsed } from '../document/album.ts';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { useGrowing } from '../ui/growing.ts';
import { ChoiceOfPhotos } from './choice-of-photos.tsx';
import { PhotoTile } from './photo-tile.tsx';
import { Stack, stacks } from './stack.tsx';
import { Videos } from './videos.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import type { TrayItem } from '../document/project.ts';
import type { Progress } from '../document/store.ts';
import type { VNode } from 'preact';

export function Tray() {
  const tile = useTiles();
  const { store, framing, ui, actions } = useApp();
  const section = useRef(null as HTMLElement | null);
  const replaces = framing.mode.value?.kind === 'replace';
  useEffect(() => {
    if (replaces) section.current?.querySelector<HTMLElement>('.photo-picture')?.focus();
  }, [replaces]);
  const tray = store.tray.value;
  const verdicts = store.verdicts.value;
  const reading = store.reading.value;
  const kept = tray.filter((item) => isUsed(item, verdicts));
  const excluded = tray.length - kept.length;
  const all = stacks(tray, verdicts);
  const open = all.get(ui.stack.value ?? '') ?? [];
  const first = open.find((item) => isUsed(item, verdicts))?.id;
  // Photos of the open stack appear only there.
  const inside = new Set(first === undefined ? [] : open.map(({ id }) => id));
  const aside = tray.filter((item) => !isUsed(item, verdicts) && !inside.has(item.id));
  const closed = kept.filter(({ id }) => !inside.has(id) || id === first);
  // One photo is a tab stop, and arrows move between photos.
  const [focused, setFocused] = useState(null as string | null);
  const order = [...closed, ...aside].map(({ id }) => id);
  const at = useRef(0);
  at.current = Math.max(0, focused !== null && order.includes(focused) ? order.indexOf(focused) : at.current);
  // If the focused photo is removed, its neighbour takes its place.
  const stop = order[Math.min(at.current, order.length - 1)];
  const shown = useGrowing([...closed.map(({ id }) => `used ${id}`), ...aside.map(({ id }) => `aside ${id}`)]);
  return (
    <section
      ref={section}
      class="tray"
      aria-label={strings.photos}
      aria-busy={reading !== null}
      data-replaces={replaces}
      onFocusIn={({ target }) => setFocused(tileOf(target)?.dataset.photo ?? focused)}
      onKeyDown={onKeyDown}
    >
      <header class="section-head">
        <h2>{strings.photos}</h2>
        <span class="count" title={excluded > 0 ? strings.excludedCount({ n: excluded }) : undefined}>
          {excluded === 0 ? tray.length : strings.photoCount({ used: kept.length, all: tray.length })}
        </span>
        {!ui.wide.value && <ActionButton action={actions.photos.subjects} />}
        <ActionButton action={actions.photos.add} />
      </header>
      {[...store.looking.value].map(([key, { name, part }]) => (
        <Looking key={key} name={name} part={part} />
      ))}
      <Videos />
      {tray.length > 1 && <ChoiceOfPhotos />}
      <ul class="photos">
        {closed
          .filter(({ id }) => shown.has(`used ${id}`))
          .map((item) => {
            const stack = all.get(item.id) ?? [];
            if (item.id === first) return <Stack key="stack" items={stack} />;
            // The first used photo represents its stack.
            const top = stack.find((other) => isUsed(other, verdicts)) === item;
            return tile(item, { used: true, stack: top ? stack.length : 0, isStop: item.id === stop });
          })}
      </ul>
      {aside.length > 0 && (
        <>
          <h3 class="aside-head">{strings.setAside}</h3>
          <p class="aside-why">{strings.setAsideWhy}</p>
        </>
      )}
      {aside.length > 0 && (
        <ul class="photos">
          {aside
            .filter(({ id }) => shown.has(`aside ${id}`))
            .map((item) => tile(item, { used: false, stack: 0, isStop: item.id === stop }))}
        </ul>
      )}
      {reading ? <Reading done={reading.done} total={reading.total} /> : <Detection />}
    </section>
  );
}

/** Steps of arrow keys between photos. */
const STEPS: Record<string, number> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

const tileOf = (target: EventTarget | null) => (target as Element | null)?.closest<HTMLElement>('.photo') ?? null;

/** Moves the focus from a control of a photo to the same control of its neighbour. */
function onKeyDown(event: KeyboardEvent & { currentTarget: HTMLElement }) {
  const { target, key, currentTarget, ctrlKey, metaKey, altKey, shiftKey } = event;
  const tile = tileOf(target);
  if (!tile || STEPS[key] === undefined || ctrlKey || metaKey || altKey || shiftKey) return;
  const tiles = [...currentTarget.querySelectorAll<HTMLElement>('.photo')];
  const next = tiles[tiles.indexOf(tile) + STEPS[key]];
  if (!next) return;
  event.preventDefault();
  event.stopPropagation();
  const { className, type } = target as HTMLInputElement;
  const same = type === 'checkbox' ? next.querySelector('input') : next.querySelector(`.${className.split(' ')[0]}`);
  ((same ?? next.querySelector('.photo-picture')) as HTMLElement).focus();
}

/**
 * The tile of a photo, the same object as long as nothing about it changes: a tray of hundreds is gone through with
 * every photo that is read.
 */
function useTiles(): (item: TrayItem, how: { used: boolean; stack: number; isStop: boolean }) => VNode {
  const drawn = useRef(new Map() as Map<string, { of: string; item: TrayItem; tile: VNode }>);
  const before = drawn.current;
  // Tiles hold their canvas, so unused tiles are dropped.
  const now: typeof before = new Map();
  drawn.current = now;
  return (item, { used, stack, isStop }) => {
    const of = `${used} ${stack} ${isStop}`;
    const last = before.get(item.id);
    const same = last?.of === of && last.item === item;
    const tile = same ? last.tile : <PhotoTile key={item.id} item={item} used={used} stack={stack} isStop={isStop} />;
    now.set(item.id, { of, item, tile });
    return tile;
  };
}

/** A video during analysis. Its frames follow afterwards, except the frames of the first page. */
function Looking({ name, part }: { name: string; part: number }) {
  const label = strings.lookingThrough({ name, percent: strings.percent(part) });
  return (
    <label class="looking">
      <span>{label}</span>
      <progress class="progress" aria-label={label} value={part} max={1} />
    </label>
  );
}

/** The progress of face and subject detection, at the bottom of the tray like `Reading`, so that no photo moves when it appears. */
function Detection() {
  const { subjects, masks, actions } = useApp();
  const finding = subjects.progress.value;
  const masking = finding ? null : masks.progress.value;
  const progress = finding ?? masking;
  const isHeld = masks.held.value;
  if (!progress && !isHeld) return null;
  const label = finding
    ? strings.finding({ done: finding.done, total: finding.total })
    : masking && strings.masking({ done: masking.done, total: masking.total });
  return (
    <div class="detection">
      {progress && <progress class="progress" aria-label={label ?? ''} value={progress.done} max={progress.total} />}
      {label && <span aria-hidden="true">{label}</span>}
      {masking && <ActionButton action={actions.photos.stopMasks} />}
      {isHeld && <ActionButton action={actions.photos.goOnMasks} text={!label} />}
    </div>
  );
}

function Reading({ done, total }: Progress) {
  const { reading } = useApp();
  const label = strings.reading({ done, total });
  return (
    <div class="detection">
      <progress class="progress" aria-label={label} value={done} max={total} />
      <span aria-hidden="true">{label}</span>
      <IconButton icon="close" label={strings.cancelReading} onClick={reading.cancel} />
    </div>
  );
}
