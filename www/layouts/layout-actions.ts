/** Actions for the whole layout. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createLayoutActions({
  store,
  reshaping,
  ownLayouts,
  ui,
}: Pick<App, 'store' | 'reshaping' | 'ownLayouts' | 'ui'>) {
  const there = computed(() => store.layoutFacts.value !== null);
  return {
    surprise: {
      label: strings.surprise,
      short: strings.surpriseShort,
      icon: 'surprise',
      enabled: there,
      run: reshaping.surprise,
      undo: 'step',
    },
    edit: {
      label: strings.editLayout,
      icon: 'edit',
      enabled: there,
      on: reshaping.editing,
      run: () => {
        reshaping.editing.value = !reshaping.editing.peek();
        // The list of layouts would leave little space for the handles.
        if (reshaping.editing.peek()) ui.sheet.value = null;
      },
    },
    save: {
      label: strings.saveLayout,
      short: strings.saveLayoutShort,
      icon: 'save',
      enabled: there,
      run: ownLayouts.save,
      undo: 'step',
    },
    forget: {
      label: strings.forgetLayout,
      icon: 'bin',
      enabled: computed(() => ownLayouts.isOwn(store.layoutFacts.value?.id ?? '')),
      run: () => ownLayouts.remove(store.layoutFacts.peek()?.id ?? ''),
      undo: 'step',
    },
  } satisfies Record<string, Action>;
}
