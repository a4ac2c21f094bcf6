/** Actions for projects. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createProjectActions({ keeping, store, ui }: Pick<App, 'keeping' | 'store' | 'ui'>) {
  const there = computed(() => store.tray.value.length > 0);
  return {
    list: {
      label: strings.projects,
      icon: 'open',
      on: computed(() => ui.work.value === 'projects'),
      run: () => ui.toggleWork('projects'),
    },
    create: {
      label: strings.newProject,
      icon: 'add',
      enabled: computed(() => there.value && !keeping.busy.value),
      run: () => void keeping.create(),
    },
    save: {
      label: strings.saveProject,
      icon: 'save',
      enabled: there,
      run: () => void keeping.files.save(),
    },
    cancelSaving: { label: strings.cancel, run: () => keeping.files.cancelSaving() },
    cancelOpening: { label: strings.cancel, run: () => keeping.files.cancel() },
  } satisfies Record<string, Action>;
}
