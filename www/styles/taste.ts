/**
 * Learned preferences, from pages that the user favours, downloads or continues. The layout and style families of these
 * pages are chosen more often. It decays, stays on this device, and can be switched off and forgotten.
 */

import { computed, signal } from '@preact/signals';
import type { Planner, Wish } from '../engine/core.ts';
import type { PageDocument } from '../engine/types.ts';

type Box = Pick<Storage, 'getItem' | 'setItem'>;
type Weights = Record<string, number>;
/** Logarithms of the factors of random choices, by id. */
type Liking = { families: Weights; styles: Weights };
export type Taste = ReturnType<typeof createTaste>;

const KEY = 'inkpanel.taste';
/** Increase for one page. */
const [FAMILY, STYLE] = [0.2, 0.35];
/** Remaining share of older preferences after each page: half after two dozen pages. */
const DECAY = 0.97;
/** Maximum preference: five times as often, so that there are still surprises. */
const MOST = 1.6;
/** Smaller values are dropped. */
const LEAST = 0.02;
/** Styles and families that are remembered. */
const COUNT = 200;

const NOTHING: Liking = Object.freeze({ families: {}, styles: {} });

/** @param app `box` may throw where storage is refused: then it is learnt for as long as the page is there */
export function createTaste({ planner, box }: { planner: () => Pick<Planner, 'layouts'> | null; box: () => Box }) {
  const kept = read(box) ?? { on: true, liking: NOTHING };
  const liking = signal<Liking>(kept.liking);
  const on = signal(kept.on);
  let families: ReadonlyMap<string, string> | null = null;

  return {
    on: computed(() => on.value),
    /** Whether there is something to forget. */
    known: computed(() => Object.keys({ ...liking.value.families, ...liking.value.styles }).length > 0),
    asked,
    learn,
    forget,
    setOn,
  };

  /** Adds the preferences to a wish with a random choice. */
  function asked(wish: Wish): Wish {
    const free = (!wish.keep.layout && wish.layout === undefined) || !wish.keep.style;
    return free && on.peek() ? { ...wish, taste: liking.peek() } : wish;
  }

  /** Learns from a page. */
  function learn(page: PageDocument) {
    if (!on.peek()) return;
    // Another tab may have learnt meanwhile.
    const before = (read(box) ?? { liking: liking.peek() }).liking;
    const family = familyOf(page.layout);
    const style = idOf(page.style);
    keep(
      {
        families: more(before.families, family, FAMILY),
        styles: more(before.styles, style, STYLE),
      },
      true,
    );
  }

  function forget() {
    keep(NOTHING, on.peek());
  }

  function setOn(wanted: boolean) {
    keep(liking.peek(), wanted);
  }

  function keep(next: Liking, wanted: boolean) {
    liking.value = next;
    on.value = wanted;
    try {
      box().setItem(KEY, JSON.stringify({ version: 1, on: wanted, ...next }));
    } catch {
      // Storage may be blocked or full. Then the preferences last until the app closes.
    }
  }

  function familyOf(layout: string | object): string | null {
    if (typeof layout !== 'string') return textOr((layout as { family?: unknown }).family);
    families ??= new Map(
      planner()
        ?.layouts()
        .map(({ id, family }) => [id, family]),
    );
    return families.get(layout) ?? null;
  }
}

function idOf(plan: string | object): string | null {
  return typeof plan === 'string' ? plan : textOr((plan as { id?: unknown }).id);
}

function textOr(value: unknown): string | null {
  return typeof value === 'string' && value !== '' ? value : null;
}

/** @returns the weights with an increase for one of them, and a decrease for all others */
function more(weights: Weights, id: string | null, gain: number): Weights {
  if (id === null) return weights;
  const faded = Object.entries(weights).map(([other, weight]) => [other, weight * DECAY] as const);
  const grown = new Map(faded.filter(([, weight]) => Math.abs(weight) >= LEAST));
  grown.set(id, Math.min(MOST, (grown.get(id) ?? 0) + gain));
  return Object.fromEntries([...grown].sort(([, a], [, b]) => b - a).slice(0, COUNT));
}

/** @returns the stored preferences; null if storage is blocked or has no valid data */
function read(box: () => Box): { on: boolean; liking: Liking } | null {
  try {
    const value = JSON.parse(box().getItem(KEY) ?? 'null');
    if (value?.version !== 1) return null;
    return { on: value.on !== false, liking: { families: weightsIn(value.families), styles: weightsIn(value.styles) } };
  } catch {
    return null;
  }
}

function weightsIn(value: unknown): Weights {
  if (typeof value !== 'object' || value === null) return {};
  const sound = Object.entries(value).filter(
    ([id, weight]) => id.length <= 200 && typeof weight === 'number' && Number.isFinite(weight),
  );
  return Object.fromEntries(sound.slice(0, COUNT).map(([id, weight]) => [id, Math.max(-MOST, Math.min(MOST, weight))]));
}
