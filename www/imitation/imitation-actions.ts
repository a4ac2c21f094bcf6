/** The way to a style from a picture, and what can be done there. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Action } from '../ui/action.ts';
import type { App } from '../ui/context.ts';

export function createImitationActions({
  imitation,
  store,
  pages,
  designer,
  ownStyles,
  ui,
}: Pick<App, 'imitation' | 'store' | 'pages' | 'designer' | 'ownStyles' | 'ui'>) {
  const shown = computed(() => imitation.proposals.value.find(({ id }) => id === imitation.shown.value));
  const there = computed(() => shown.value !== undefined);
  return {
    open: {
      label: strings.styleFromPicture,
      help: strings.styleFromPictureHelp,
      icon: 'imitate',
      enabled: computed(() => store.tray.value.length > 0),
      run: imitation.open,
    },
    stop: {
      label: strings.stop,
      icon: 'close',
      enabled: computed(() => imitation.progress.value !== null),
      run: imitation.stop,
    },
    use: {
      label: strings.useStyle,
      icon: 'check',
      enabled: computed(() => there.value && store.page.value !== null),
      run: () => {
        const style = shown.peek();
        if (!style) return;
        pages.chooseStyle(style);
        ui.work.value = null;
      },
      undo: 'step',
    },
    edit: {
      label: strings.editInDesigner,
      icon: 'designer',
      enabled: there,
      run: () => {
        const style = shown.peek();
        if (style) designer.open(style);
      },
    },
    save: {
      label: strings.saveStyle,
      icon: 'save',
      enabled: there,
      run: () => {
        const style = shown.peek();
        if (style) ownStyles.save(style);
      },
      undo: 'step',
    },
  } satisfies Record<string, Action>;
}
