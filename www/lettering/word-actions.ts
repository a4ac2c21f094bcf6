/** Actions that add text items, actions of the selected text item, and actions of all unplaced text. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';
import type { Mode } from './lettering.ts';
import { LEAST_SIZE, MOST_SIZE } from './word-units.ts';

type Kind = keyof typeof strings.addWord;

export function createWordActions({ store, ui, lettering }: Pick<App, 'store' | 'ui' | 'lettering'>) {
  const enabled = computed(() => store.page.value !== null);

  const added = (kind: Kind) =>
    ({
      label: strings.addWord[kind],
      short: strings.wordShort[kind],
      icon: kind,
      enabled,
      run: () => void add(kind),
      undo: 'step',
    }) satisfies Action;

  async function add(kind: Kind) {
    if (!(await lettering.add(kind))) return;
    if (!ui.wide.peek()) ui.sheet.value = null;
    lettering.editing.value = lettering.words.peek().length - 1;
  }

  return {
    addCaption: added('caption'),
    addBalloon: added('balloon'),
    addEffect: added('effect'),
    addTitle: added('title'),
  };
}

/** The text size changes by this factor with each press. */
const GROWTH = 1.12;

export function createTextActions({
  store,
  ui,
  lettering,
  subtitling,
}: Pick<App, 'store' | 'ui' | 'lettering' | 'subtitling'>) {
  const { chosen, mode } = lettering;
  const word = computed(() => lettering.words.value[chosen.value]);
  const box = computed(() => lettering.boxes.value[chosen.value]);
  const enabled = computed(() => box.value !== undefined);
  const isBalloon = computed(() => word.value?.kind === 'balloon');

  /** The next click on the page sets a place. On a small screen the drawer would hide the page. */
  function aim(next: Mode) {
    mode.value = mode.peek() === next ? null : next;
    if (!ui.wide.peek()) ui.sheet.value = null;
  }

  function grow(by: number) {
    const { size } = box.peek() ?? {};
    if (size === undefined) return;
    lettering.edit(chosen.peek(), { size: Math.min(MOST_SIZE, Math.max(LEAST_SIZE, size * by)) }, lettering.step());
  }

  async function putScript() {
    if (await subtitling.put(subtitling.draft.peek())) subtitling.draft.value = '';
  }

  return {
    edit: {
      label: strings.editWord,
      icon: 'text',
      enabled,
      run: () => {
        lettering.editing.value = chosen.peek();
        if (!ui.wide.peek()) ui.sheet.value = null;
      },
    },
    format: {
      label: strings.formatWord,
      icon: 'style',
      enabled,
      run: () => {
        if (ui.wide.peek()) ui.sideTab.value = 'words';
        else ui.sheet.value = 'words';
      },
    },
    smaller: { label: strings.barSmaller, icon: 'smaller', enabled, run: () => grow(1 / GROWTH), undo: 'step' },
    larger: { label: strings.barLarger, icon: 'larger', enabled, run: () => grow(GROWTH), undo: 'step' },
    pointTail: {
      label: strings.pointTail,
      icon: 'focus',
      enabled: isBalloon,
      on: computed(() => mode.value === 'tail'),
      run: () => aim('tail'),
    },
    move: {
      label: strings.moveWord,
      icon: 'put',
      enabled,
      on: computed(() => mode.value === 'move'),
      run: () => aim('move'),
    },
    place: {
      label: strings.placeWord,
      icon: 'reset',
      enabled,
      run: () => lettering.settleOne(chosen.peek()),
      undo: 'step',
    },
    match: {
      label: strings.matchWords,
      icon: 'text',
      enabled: computed(() => enabled.value && lettering.alike(chosen.value).length > 0),
      run: () => lettering.match(chosen.peek(), lettering.step()),
      undo: 'step',
    },
    removeTail: {
      label: strings.removeTail,
      icon: 'close',
      enabled: computed(() => isBalloon.value && (box.value?.tip ?? null) !== null),
      run: () => lettering.point(chosen.peek(), null),
      undo: 'step',
    },
    remove: {
      label: strings.removeWord,
      icon: 'bin',
      keys: ['Delete', 'Backspace'],
      enabled,
      run: () => lettering.remove(chosen.peek()),
      undo: 'step',
    },
    putScript: {
      label: strings.putScript,
      icon: 'balloon',
      enabled: computed(() => subtitling.draft.value.trim() !== '' && store.page.value !== null),
      run: () => void putScript(),
      undo: 'step',
    },
    dropAll: {
      label: strings.dropAllWaiting,
      icon: 'bin',
      enabled: computed(() => lettering.waiting.value.length > 0),
      run: () => lettering.drop(lettering.waiting.peek().map((_, i) => i)),
      undo: 'step',
    },
  } satisfies Record<string, Action>;
}
