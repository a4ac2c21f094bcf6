/** Actions for the whole page. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { WALK_KEYS } from './panels/panel-keys.ts';
import type { App } from '../ui/context.ts';
import type { Part } from '../document/project.ts';
import type { Action, OwnKeys } from '../ui/action.ts';

export function createPageActions({
  store,
  pages,
  crops,
  shownPages,
  ui,
}: Pick<App, 'store' | 'pages' | 'crops' | 'shownPages' | 'ui'>) {
  const there = computed(() => store.page.value !== null);
  const at = store.versionIndex;
  const count = computed(() => store.versions.value.length);

  const shuffled = (part: Part) =>
    ({
      label: strings.shufflePart[part],
      short: strings.part[part],
      icon: part,
      enabled: computed(() => there.value && !store.project.value.locks[part]),
      run: () => pages.shuffle(part),
      undo: 'step',
    }) satisfies Action;

  const locked = (part: Part) => {
    const on = computed(() => store.project.value.locks[part]);
    return {
      label: strings.lockPart[part],
      icon: computed(() => (on.value ? 'lock' : 'unlock')),
      on,
      run: () => pages.lock(part, !on.peek()),
      undo: 'step',
    } satisfies Action;
  };

  return {
    shuffle: {
      label: strings.shuffle,
      keys: ['Space'],
      icon: 'shuffle',
      enabled: there,
      run: () => pages.shuffle('all'),
      undo: 'step',
    },
    shuffleLayout: { ...shuffled('layout'), keys: ['L'] },
    shuffleStyle: { ...shuffled('style'), keys: ['S'] },
    shufflePhotos: { ...shuffled('photos'), keys: ['P'] },
    lockLayout: locked('layout'),
    lockStyle: locked('style'),
    lockPhotos: locked('photos'),
    undo: {
      label: strings.undo,
      keys: ['Mod+Z'],
      heard: 'everywhere',
      icon: 'undo',
      enabled: store.canUndo,
      run: pages.undo,
    },
    redo: {
      label: strings.redo,
      keys: ['Shift+Mod+Z', 'Mod+Y'],
      heard: 'everywhere',
      icon: 'redo',
      enabled: store.canRedo,
      run: pages.redo,
    },
    walk: WALK_KEYS,
    previous: {
      label: strings.previous,
      help: strings.previousHelp,
      icon: 'previous',
      enabled: computed(() => at.value > 0),
      run: pages.previous,
      undo: 'step',
    },
    next: {
      label: strings.next,
      help: strings.nextHelp,
      icon: 'next',
      enabled: computed(() => at.value < count.value - 1),
      run: pages.next,
      undo: 'step',
    },
    versions: {
      label: computed(() => strings.pagesShownAt({ n: at.value + 1, of: count.value })),
      help: computed(() => strings.version({ n: at.value + 1, of: count.value })),
      on: computed(() => ui.work.value === 'pages'),
      run: () => ui.toggleWork('pages'),
    },
    ideas: {
      label: computed(() => (ui.ideas.value ? strings.foldIdeas : strings.unfoldIdeas)),
      short: strings.alternatives,
      icon: computed(() => (ui.ideas.value ? 'fold' : 'unfold')),
      on: ui.ideas,
      run: ui.toggleIdeas,
    },
    acceptCrops: {
      label: strings.betterCrops,
      help: strings.betterCropsWhy,
      icon: 'surprise',
      enabled: computed(() => crops.offered.value !== null),
      run: crops.accept,
      undo: 'step',
    },
    favourite: {
      label: strings.favouritePage,
      icon: 'heart',
      enabled: there,
      on: shownPages.loved,
      run: shownPages.loveThis,
      undo: 'step',
    },
  } satisfies Record<string, Action | OwnKeys>;
}
