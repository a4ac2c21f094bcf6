// @ts-check
/**
 * A style while it is designed: plain data, and the pure function that changes it. Every block has a key, so that its
 * card stays the same card wherever it is moved, and all of its values, so that a control never guesses.
 */

import { MOST, wellFormed } from './limits.js';

/** @typedef {import('../engine/documents.js').Block} Block */
/** @typedef {import('../engine/documents.js').Style} Style */
/** @typedef {'background' | 'foreground'} Layer */
/** @typedef {{ key: number, block: string, values: Record<string, any>, bypass: boolean }} Step */
/** @typedef {{ id: string, name: string, tags: string[], background: readonly Step[], foreground: readonly Step[], ink: string }} Draft */

/**
 * A place is a layer and a position in it.
 * @typedef {(
 *   | { type: 'add', layer: Layer, at: number, blocks: string[] }
 *   | { type: 'move', layer: Layer, at: number, toLayer: Layer, to: number }
 *   | { type: 'remove', layer: Layer, at: number }
 *   | { type: 'duplicate', layer: Layer, at: number }
 *   | { type: 'bypass', layer: Layer, at: number, on: boolean }
 *   | { type: 'set', layer: Layer, at: number, param: string, value: any }
 *   | { type: 'reset', layer: Layer, at: number }
 *   | { type: 'name', name: string }
 *   | { type: 'ink', ink: string }
 * )} Edit
 */

/** @type {readonly Layer[]} */
export const LAYERS = ['background', 'foreground'];
/** Blocks that the core takes in one layer. */
export const MOST_BLOCKS = 32;

/**
 * @param {string} id
 * @param {string} name
 * @returns {Draft}
 */
export function emptyDraft(id, name) {
  return { id, name, tags: [], background: [], foreground: [], ink: '#000000' };
}

/**
 * @param {Style} style a valid one
 * @param {readonly Block[]} blocks
 * @returns {Draft}
 */
export function draftOf(style, blocks) {
  let key = 0;
  const steps = (/** @type {any[]} */ list) => list.map(({ block, bypass = false, ...values }) => {
    key += 1;
    return { key, block, values: { ...defaults(block, blocks), ...values }, bypass };
  });
  return {
    id: style.id, name: style.name, tags: [...style.tags], background: steps(style.background ?? []), foreground: steps(style.foreground ?? []),
    ink: style.ink ?? '#000000',
  };
}

/**
 * The style file of a draft. What is the default is left out.
 * @param {Draft} draft
 * @param {readonly Block[]} blocks
 * @param {{ tolerant?: boolean }} [how] `tolerant`: blocks that cannot take what comes before them are bypassed
 * @returns {Style}
 */
export function styleOf(draft, blocks, { tolerant = false } = {}) {
  const steps = (/** @type {Layer} */ layer) => {
    const wrong = tolerant ? misfits(draft[layer], blocks) : [];
    return draft[layer].map(({ block, values, bypass }, i) => {
      const usual = defaults(block, blocks);
      const told = Object.entries(values).filter(([name, value]) => value !== usual[name]);
      return { block, ...Object.fromEntries(told), ...(bypass || wrong[i] ? { bypass: true } : {}) };
    });
  };
  return {
    id: draft.id, name: draft.name.trim() || draft.id, tags: draft.tags, background: steps('background'),
    ...(draft.foreground.length > 0 ? { foreground: steps('foreground') } : {}),
    ...(draft.ink === '#000000' ? {} : { ink: draft.ink }),
  };
}

/**
 * What each block lacks: `luma`, `color`, or nothing. A bypassed block lacks nothing, and one that lacks something
 * is passed over by those behind it.
 * @param {readonly Step[]} steps
 * @param {readonly Block[]} blocks
 * @returns {('' | 'luma' | 'color')[]}
 */
export function misfits(steps, blocks) {
  let channels = 'color';
  return steps.map(({ block, bypass }) => {
    const found = blocks.find(({ id }) => id === block);
    if (!found || bypass) return '';
    if (found.input !== 'any' && found.input !== channels) return /** @type {'luma' | 'color'} */ (found.input);
    if (found.output !== 'any') channels = found.output;
    return '';
  });
}

/**
 * What must stand before a block at the end of some steps, so that it can work there.
 * @param {readonly Step[]} steps
 * @param {string} block
 * @param {readonly Block[]} blocks
 * @returns {string | null} the id of a block
 */
export function remedy(steps, block, blocks) {
  const lacks = misfits([...steps, { key: 0, block, values: {}, bypass: false }], blocks).at(-1);
  return lacks ? REMEDIES[lacks] : null;
}

/** The block that gives what is lacking. */
export const REMEDIES = { luma: 'to_gray', color: 'to_color' };

/**
 * @param {Draft} draft
 * @param {Edit} change
 * @param {readonly Block[]} blocks
 * @returns {Draft} the same object when nothing changed
 */
export function edit(draft, change, blocks) {
  if (change.type === 'name') return { ...draft, name: wellFormed(change.name).slice(0, MOST.name) };
  if (change.type === 'ink') return { ...draft, ink: change.ink };
  const { layer, at } = change;
  const steps = [...draft[layer]];
  const step = steps[at];
  if (change.type === 'add') {
    if (steps.length + change.blocks.length > MOST_BLOCKS) return draft;
    const first = freshKey(draft);
    steps.splice(at, 0, ...change.blocks.map((block, i) => ({ key: first + i, block, values: defaults(block, blocks), bypass: false })));
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

/**
 * @param {string} id
 * @param {readonly Block[]} blocks
 * @returns {Record<string, any>}
 */
export function defaults(id, blocks) {
  const params = blocks.find((block) => block.id === id)?.params ?? [];
  return Object.fromEntries(params.map((param) => [param.id, param.default]));
}

/** @param {Draft} draft */
function freshKey({ background, foreground }) {
  return [...background, ...foreground].reduce((most, { key }) => Math.max(most, key), 0) + 1;
}
