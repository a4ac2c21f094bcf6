/** Actions for projects. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createProjectActions({ keeping, store, ui }: Pick<App, 'keeping' | 'store' | 'ui'>) {
  const there = computed(() => store.tray.value.length > 0);

  /** @param done whether a project was opened */
  function closeList(done: boolean) {
    if (done) ui.work.value = null;
  }

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
    openCopy: {
      label: strings.openCopy,
      enabled: computed(() => keeping.elsewhere.value !== null),
      run: () => void keeping.openCopy().then(closeList),
    },
    goBack: {
      label: strings.goBack,
      enabled: computed(() => keeping.broken.value?.back === true),
      run: () => void keeping.goBack().then(closeList),
    },
    openAnother: {
      label: strings.openAnother,
      run: () => {
        ui.work.value = 'projects';
      },
    },
    saveBroken: {
      label: strings.saveAsFile,
      enabled: computed(() => keeping.broken.value !== null),
      run: () => void keeping.saveBroken(),
    },
    cancelSaving: { label: strings.cancel, run: () => keeping.files.cancelSaving() },
    cancelOpening: { label: strings.cancel, run: () => keeping.files.cancel() },
  } satisfies Record<string, Action>;
}
