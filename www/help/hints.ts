/**
 * Three hints at first use, one at a time and each only once: shuffle, move the picture of a panel, lock. A hint
 * disappears after its action, after shuffles without it, and with Escape.
 */

import { computed, effect, signal } from '@preact/signals';
import type { Lettering } from '../lettering/lettering.ts';
import type { Framing } from '../page/panels/framing.ts';
import type { Reshaping } from '../page/panels/reshaping.ts';
import type { Selection } from '../page/panels/selection.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Ui } from '../ui/ui.ts';

/** In the order in which they are given where several are due. */
const HINTS = ['shuffle', 'crop', 'lock'] as const;
export type Hint = (typeof HINTS)[number];
export type Hints = ReturnType<typeof createHints>;

const KEY = 'inkpanel.hints';
/** Minimum number of shuffles before the hint for locking. */
const ENOUGH = 2;

/** @param parts `box`: storage of the hints that were shown; it may be unavailable */
export function createHints({
  store,
  selection,
  lettering,
  framing,
  reshaping,
  ui,
  box,
}: {
  store: Store;
  selection: Selection;
  lettering: Pick<Lettering, 'chosen'>;
  framing: Framing;
  reshaping: Reshaping;
  ui: Pick<Ui, 'painted' | 'work' | 'sheet' | 'dialog' | 'preview'>;
  box: () => Storage;
}) {
  const seen = signal(recall(box));
  /** Since the hints began. */
  const shuffles = signal(0);
  /** Whether the user restarted the hints. Then earlier shuffles do not count. */
  const again = signal(false);
  /** The panel that the pointer rests on. */
  const pointed = signal<number | null>(null);
  const current = signal<Hint | null>(null);
  /** The crops of the page and the number of shuffles when the hint about them was given. */
  let crops = '';
  let before = 0;
  /** Whether the hint about photos is about a selected panel. */
  let ofSelection = false;
  /** Whether the user cropped a photo since the hint about photos. */
  let cropped = false;

  const panel = computed(() => selection.panels.value[0] ?? pointed.value);
  /** Whether no other element needs the user's attention. */
  const free = computed(
    () =>
      ui.work.value === null &&
      ui.sheet.value === null &&
      ui.dialog.value === null &&
      !ui.preview.value &&
      !reshaping.editing.value &&
      framing.placing.value === null,
  );
  const there = computed(
    () => store.page.value !== null && ui.painted.value === store.page.value && store.reading.value === null,
  );
  /** Whether a panel or a text item is selected. */
  const selects = computed(() => selection.panels.value.length > 0 || lettering.chosen.value >= 0);
  const locked = computed(() => Object.values(store.project.value.locks).some(Boolean));

  const due: Record<Hint, () => boolean> = {
    shuffle: () => shuffles.value === 0 && (again.value || store.versions.value.length === 1),
    crop: () =>
      panel.value !== null &&
      lettering.chosen.value < 0 &&
      framing.cropOf(panel.value) !== null &&
      !framing.isLocked(panel.value),
    lock: () => shuffles.value >= ENOUGH && !locked.value && !selects.value,
  };
  const done: Record<Hint, () => boolean> = {
    // A user who selects something needs no hint for Shuffle.
    shuffle: () => shuffles.value > 0 || selects.value,
    // The hint ends if the user shuffles again, works on a text item, ends the crop, or leaves the panel.
    crop: () =>
      shuffles.value > before ||
      (framing.cropping.value === null && cropped) ||
      framing.mode.value !== null ||
      selection.panels.value.length > 1 ||
      (ofSelection && selection.panels.value.length === 0) ||
      lettering.chosen.value >= 0 ||
      (cropsOf(store.page.value) !== crops && (store.page.value?.panels.some(({ edited }) => edited) ?? false)),
    lock: () => locked.value || lettering.chosen.value >= 0 || shuffles.value >= before + ENOUGH,
  };

  effect(() => {
    if (framing.cropping.value !== null) cropped = true;
  });
  effect(() => {
    const hint = current.value;
    if (hint !== null && done[hint]()) current.value = null;
  });
  effect(() => {
    if (current.value !== null || !there.value || !free.value) return;
    const next = HINTS.find((hint) => !seen.value.has(hint) && due[hint]());
    if (next === undefined) return;
    crops = cropsOf(store.page.peek());
    before = shuffles.peek();
    ofSelection = selection.panels.peek().length > 0;
    cropped = framing.cropping.peek() !== null;
    current.value = next;
    remember(new Set([...seen.peek(), next]));
  });
  // Closing a project ends its hint, and the next project starts without one.
  effect(() => {
    if (store.page.value === null) current.value = null;
  });

  function remember(now: ReadonlySet<Hint>) {
    seen.value = now;
    try {
      box().setItem(KEY, [...now].join(' '));
    } catch {
      // Storage may be blocked. Then the hints appear once per visit.
    }
  }

  return {
    /** The hint that is visible now. */
    shown: computed(() => (free.value ? current.value : null)),
    /** The panel that the hint about pictures is for. */
    panel,
    /** Whether it is worth watching where the pointer rests. */
    watches: computed(() => !seen.value.has('crop')),
    point(at: number | null) {
      pointed.value = at;
    },
    shuffled() {
      shuffles.value += 1;
    },
    close() {
      current.value = null;
    },
    /** Forgets that they were seen. */
    begin() {
      shuffles.value = 0;
      again.value = true;
      current.value = null;
      remember(new Set());
    },
  };
}

/** How all is cropped. */
function cropsOf(page: PageDocument | null): string {
  return JSON.stringify(page?.panels.map(({ crop }) => crop));
}

function recall(box: () => Storage): ReadonlySet<Hint> {
  try {
    const kept = (box().getItem(KEY) ?? '').split(' ');
    return new Set(HINTS.filter((hint) => kept.includes(hint)));
  } catch {
    return new Set();
  }
}
