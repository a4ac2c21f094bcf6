/** Actions for the whole wall of styles. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createExplorerActions({ explorer }: Pick<App, 'explorer'>) {
  return {
    stop: {
      label: strings.stop,
      icon: 'close',
      enabled: computed(() => explorer.progress.value !== null),
      run: explorer.stop,
    },
    cancelCombining: {
      label: strings.cancel,
      enabled: computed(() => explorer.parent.value !== null),
      run: () => {
        explorer.parent.value = null;
      },
    },
    stopJudging: { label: strings.stopJudging, run: explorer.scores.pause },
    sort: {
      label: strings.sortByScore,
      help: computed(() => (explorer.scores.off.value ? strings.sortedByLight : strings.sortedByNet)),
      enabled: computed(() => explorer.items.value.length > 0),
      run: explorer.sort,
    },
    clear: {
      label: strings.clearWall,
      icon: 'bin',
      enabled: computed(() => explorer.items.value.length > 0),
      run: explorer.clear,
    },
  } satisfies Record<string, Action>;
}
