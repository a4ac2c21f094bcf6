/** Actions for the style of the page. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Style } from '../engine/types.ts';
import type { Action } from '../ui/action.ts';

/** The style of the page in full. */
export function styleOfPage({ store, ownStyles }: Pick<App, 'store' | 'ownStyles'>) {
  const style = store.page.value?.style;
  if (typeof style !== 'string') return style as Style | undefined;
  return ownStyles.find(style) ?? store.styles.value.find(({ id }) => id === style);
}

export function createStyleActions({
  store,
  ownStyles,
  designer,
  styling,
  taste,
  ui,
}: Pick<App, 'store' | 'ownStyles' | 'designer' | 'styling' | 'taste' | 'ui'>) {
  const style = computed(() => styleOfPage({ store, ownStyles }));
  const kept = (part: 'keepColours' | 'keepLines') => {
    const on = computed(() => store.project.value.styling[part] ?? false);
    return {
      label: strings[part],
      on,
      run: () => styling.change({ [part]: !on.peek() }),
      undo: 'step',
    } satisfies Action;
  };

  return {
    keepColours: kept('keepColours'),
    keepLines: kept('keepLines'),
    forgetTaste: {
      label: strings.forgetTaste,
      enabled: computed(() => taste.known.value),
      run: () => taste.forget(),
    },
    edit: {
      label: computed(() =>
        style.value ? strings.editStyle({ name: strings.styleTitle(style.value) }) : strings.edit,
      ),
      icon: 'designer',
      enabled: computed(() => style.value !== undefined),
      run: () => designer.open(style.peek()),
    },
    shuffleSettings: {
      label: strings.styleShuffle,
      icon: 'settings',
      on: ui.styleShuffle,
      run: () => {
        ui.styleShuffle.value = !ui.styleShuffle.peek();
        ui.sideTab.value = 'styles';
      },
    },
  } satisfies Record<string, Action>;
}
