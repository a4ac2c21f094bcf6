/** Actions for exporting the page. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createDownloadActions({
  store,
  download,
  boards,
  exportChoice,
  ui,
}: Pick<App, 'store' | 'download' | 'boards' | 'exportChoice' | 'ui'>) {
  return {
    download: {
      label: strings.download,
      keys: ['Mod+S'],
      icon: 'download',
      enabled: computed(() => store.page.value !== null),
      why: computed(() => (download.progress.value === null ? '' : strings.exportRuns)),
      run: () => void download.start(),
    },
    cancel: { label: strings.cancel, run: download.cancel },
    hideMarks: {
      label: strings.print.coarseHide,
      enabled: computed(() => ui.printCheck.value !== null),
      run: () => {
        ui.printCheck.value = null;
      },
    },
    exportPages: {
      label: strings.export,
      icon: 'export',
      enabled: computed(() => store.page.value !== null),
      run: () => {
        // The dialog begins with the sheets on the storyboard.
        if (ui.work.peek() === 'boards' && boards.rows.peek().length > 0) exportChoice.asked.value = 'boardPdf';
        ui.dialog.value = 'export';
      },
    },
  } satisfies Record<string, Action>;
}
