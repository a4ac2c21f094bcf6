/** Actions for the storyboard. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createBoardActions({
  boards,
  store,
  exportChoice,
  ui,
}: Pick<App, 'boards' | 'store' | 'exportChoice' | 'ui'>) {
  return {
    animatic: {
      label: strings.exportFormats.animatic,
      icon: 'film',
      enabled: computed(() => boards.rows.value.length > 0 && store.page.value !== null),
      run: () => {
        exportChoice.asked.value = 'animatic';
        ui.dialog.value = 'export';
      },
    },
    filmBoard: {
      label: strings.boards.filmBoard,
      icon: 'style',
      run: () => boards.filmBoard(),
      undo: 'step',
    },
    followPages: {
      label: strings.boards.followPages,
      icon: 'reset',
      enabled: computed(() => boards.board.value.order.length > 0),
      run: () => boards.followPages(),
      undo: 'step',
    },
  } satisfies Record<string, Action>;
}
