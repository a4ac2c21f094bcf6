/** Selection settings: maximum similarity of photos, and their order. */

import { useState } from 'preact/hooks';
import { DUPLICATE_THRESHOLD } from '../engine/bounds.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { Order } from '../document/project.ts';
import type { Store } from '../document/store.ts';

/** Descriptions of thresholds, each with the first number of bits that is above its range. */
const SIMILARITIES = [
  [7, 'identical'],
  [11, 'scene'],
  [14, 'very'],
  [Number.POSITIVE_INFINITY, 'somewhat'],
] as const;

/** @returns the key of the description of a threshold */
const similarityOf = (bits: number) => (SIMILARITIES.find(([below]) => bits < below) ?? SIMILARITIES[3])[1];

export function ChoiceOfPhotos() {
  const { store, choosing } = useApp();
  const { alike: duplicateThreshold, order } = store.project.value;
  /** Position of the slider while it is dragged. */
  const [wish, setWish] = useState(null as number | null);
  const [open, setOpen] = useState(false);
  const shown = wish ?? duplicateThreshold;
  const busy = store.reading.value !== null;
  return (
    <details class="photo-choice" onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>{strings.choice}</summary>
      <label class="field">
        <span>{strings.alike}</span>
        <input
          type="range"
          min={DUPLICATE_THRESHOLD.min}
          max={DUPLICATE_THRESHOLD.max}
          value={shown}
          disabled={busy}
          aria-valuetext={strings.alikeValue[similarityOf(shown)]({ bits: shown })}
          onInput={({ currentTarget }) => setWish(currentTarget.valueAsNumber)}
          onChange={({ currentTarget }) => {
            setWish(null);
            choosing.setDuplicateThreshold(currentTarget.valueAsNumber);
          }}
        />
        <output aria-hidden="true">
          {open && !busy && strings.alikeKept({ kept: keptAt(store, shown), all: store.tray.value.length })}
        </output>
      </label>
      <label class="field">
        <span>{strings.order}</span>
        <select
          class="select"
          value={order}
          disabled={busy}
          onChange={({ currentTarget }) => choosing.setOrder(currentTarget.value as Order)}
        >
          <option value="time">{strings.orders.time}</option>
          <option value="name">{strings.orders.name}</option>
        </select>
      </label>
    </details>
  );
}

/** How many photos the selection would keep. */
function keptAt(store: Store, duplicateThreshold: number) {
  const photos = store.measured.value;
  return store.planner.value?.choose(photos, duplicateThreshold).filter(({ kept }) => kept).length ?? photos.length;
}
