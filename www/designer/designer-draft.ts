/**
 * A style while it is designed: plain data, and the pure function that changes it. Every block has a key, so that its
 * card stays the same card wherever it is moved, and all of its values, so that a control never guesses.
 */

import { MOST, wellFormed } from '../document/limits.ts';
import type { Block, Draft, DraftStep, ParamValue, Style, StyleStep } from '../engine/types.ts';

export type Layer = 'background' | 'foreground';
export type { Draft };
export type Step = DraftStep;
type Values = Step['values'];

/** A place is a layer and a position in it. */
export type Edit =
  | { type: 'add'; layer: Layer; at: number; blocks: string[] }
  | { type: 'move'; layer: Layer; at: number; toLayer: Layer; to: number }
  | { type: 'remove'; layer: Layer; at: number }
  | { type: 'duplicate'; layer: Layer; at: number }
  | { type: 'bypass'; layer: Layer; at: number; on: boolean }
  | { type: 'set'; layer: Layer; at: number; param: string; value: ParamValue }
  | { type: 'reset'; layer: Layer; at: number }
  | { type: 'name'; name: string }
  | { type: 'ink'; ink: string };

export const LAYERS: readonly Layer[] = ['background', 'foreground'];
/** Blocks that the core takes in one layer. */
export const MOST_BLOCKS = MOST.blocks;

export function emptyDraft(id: string, name: string): Draft {
  return { id, name, tags: [], background: [], foreground: [], ink: '#000000' };
}

/** @param style a valid one */
export function draftOf(style: Style, blocks: readonly Block[]): Draft {
  let key = 0;
  const steps = (list: readonly StyleStep[]) =>
    list.map(({ block, bypass = false, ...values }) => {
      key += 1;
      return { key, block, values: { ...defaults(block, blocks), ...values }, bypass };
    });
  return {
    id: style.id,
    name: style.name,
    tags: [...style.tags],
    background: steps(style.background ?? []),
    foreground: steps(style.foreground ?? []),
    ink: style.ink ?? '#000000',
  };
}

/**
 * The style file of a draft. What is the default is left out.
 * @param how `tolerant`: blocks that cannot take what comes before them are bypassed
 */
export function styleOf(
  draft: Draft,
  blocks: readonly Block[],
  { tolerant = false }: { tolerant?: boolean } = {},
): Style {
  const steps = (layer: Layer) => {
    const wrong = tolerant ? misfits(draft[layer], blocks) : [];
    return draft[layer].map(({ block, values, bypass }, i) => {
      const usual = defaults(block, blocks);
      const told = Object.entries(values).filter(([name, value]) => value !== usual[name]);
      return { block, ...Object.fromEntries(told), ...(bypass || wrong[i] ? { bypass: true } : {}) };
    });
  };
  return {
    id: draft.id,
    name: draft.name.trim() || draft.id,
    tags: draft.tags,
    background: steps('background'),
    ...(draft.foreground.length > 0 ? { foreground: steps('foreground') } : {}),
    ...(draft.ink === '#000000' ? {} : { ink: draft.ink }),
  };
}

/**
 * What each block lacks: `luma`, `color`, or nothing. A bypassed block lacks nothing, and one that lacks something
 * is passed over by those behind it.
 */
export function misfits(steps: readonly Step[], blocks: readonly Block[]): ('' | 'luma' | 'color')[] {
  let channels = 'color';
  return steps.map(({ block, bypass }) => {
    const found = blocks.find(({ id }) => id === block);
    if (!found || bypass) return '';
    if (found.input !== 'any' && found.input !== channels) return found.input as 'luma' | 'color';
    if (found.output !== 'any') channels = found.output;
    return '';
  });
}

/**
 * What must stand before a block at the end of some steps, so that it can work there.
 * @returns the id of a block
 */
export function remedy(steps: readonly Step[], block: string, blocks: readonly Block[]): string | null {
  const lacks = misfits([...steps, { key: 0, block, values: {}, bypass: false }], blocks).at(-1);
  return lacks ? REMEDIES[lacks] : null;
}

/** The block that gives what is lacking. */
export const REMEDIES = { luma: 'to_gray', color: 'to_color' };

/** @returns the same object when nothing changed */
export function edit(draft: Draft, change: Edit, blocks: readonly Block[]): Draft {
  if (change.type === 'name') return { ...draft, name: wellFormed(change.name).slice(0, MOST.name) };
  if (change.type === 'ink') return { ...draft, ink: change.ink };
  const { layer, at } = change;
  const steps = [...draft[layer]];
  const step = steps[at];
  if (change.type === 'add') {
    if (steps.length + change.blocks.length > MOST_BLOCKS) return draft;
    const first = freshKey(draft);
    steps.splice(
      at,
      0,
      ...change.blocks.map((block, i) => ({ key: first + i, block, values: defaults(block, blocks), bypass: false })),
    );
    return { ...draft, [layer]: steps };
  }
  if (!step) return draft;
  switch (change.type) {
    case 'move': {
      const { toLayer, to } = change;
      if (toLayer !== layer && draft[toLayer].length >= MOST_BLOCKS) return draft;
      steps.splice(at, 1);
      const target = toLayer === layer ? steps : [...draft[toLayer]];
      const place = Math.max(0, Math.min(target.length, to));
      if (toLayer === layer && place === at) return draft;
      target.splice(place, 0, step);
      return { ...draft, [layer]: steps, [toLayer]: target };
    }
    case 'remove':
      steps.splice(at, 1);
      break;
    case 'duplicate':
      if (steps.length >= MOST_BLOCKS) return draft;
      steps.splice(at + 1, 0, { ...step, key: freshKey(draft) });
      break;
    case 'bypass':
      steps[at] = { ...step, bypass: change.on };
      break;
    case 'set':
      if (step.values[change.param] === change.value) return draft;
      steps[at] = { ...step, values: { ...step.values, [change.param]: change.value } };
      break;
    case 'reset':
      steps[at] = { ...step, values: defaults(step.block, blocks) };
      break;
    default:
      return draft;
  }
  return { ...draft, [layer]: steps };
}

export function defaults(id: string, blocks: readonly Block[]): Values {
  const params = blocks.find((block) => block.id === id)?.params ?? [];
  return Object.fromEntries(params.map((param) => [param.id, param.default]));
}

function freshKey({ background, foreground }: Draft) {
  return [...background, ...foreground].reduce((most, { key }) => Math.max(most, key), 0) + 1;
}
