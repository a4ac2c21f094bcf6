/** Actions for the whole designed style. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Style } from '../engine/types.ts';
import type { Action } from '../ui/action.ts';

export function createDesignerActions({ store, designer, ownStyles }: Pick<App, 'store' | 'designer' | 'ownStyles'>) {
  const { draft } = designer;
  const empty = computed(() => !draft.value || draft.value.background.length + draft.value.foreground.length === 0);

  /** @param deed on the style as the core has checked it */
  const withStyle = (deed: (style: Style) => void) => () => {
    const style = designer.checked();
    if (style) deed(style);
  };

  return {
    begin: {
      label: strings.beginWithPage,
      icon: 'style',
      enabled: computed(() => store.page.value !== null),
      run: designer.beginWithPage,
      undo: 'step',
    },
    save: {
      label: strings.saveStyle,
      icon: 'save',
      enabled: computed(() => !empty.value),
      run: withStyle(ownStyles.save),
      undo: 'step',
    },
    exportStyle: {
      label: strings.exportStyle,
      icon: 'export',
      run: withStyle(ownStyles.exportFile),
    },
    copyLink: {
      label: strings.copyLink,
      short: strings.styleToolShort.link,
      icon: 'link',
      run: withStyle(
        (style) =>
          void ownStyles.copyLink(style, {
            address: globalThis.location.href,
            write: async (text) => navigator.clipboard.writeText(text),
          }),
      ),
    },
    duplicate: {
      label: strings.duplicateStyle,
      short: strings.styleToolShort.duplicate,
      icon: 'duplicate',
      run: withStyle((style) => designer.begin(ownStyles.duplicate(style))),
      undo: 'step',
    },
    remove: {
      label: strings.deleteStyle,
      short: strings.styleToolShort.delete,
      icon: 'bin',
      enabled: computed(() => ownStyles.mine.value.some(({ id }) => id === draft.value?.id)),
      run: () => ownStyles.remove(draft.peek()?.id ?? ''),
      undo: 'step',
    },
    use: {
      label: strings.useStyle,
      icon: 'check',
      enabled: computed(() => store.page.value !== null),
      run: designer.use,
      undo: 'step',
    },
  } satisfies Record<string, Action>;
}
