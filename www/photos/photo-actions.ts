/** Actions for all photos. */

import { strings } from '../strings/strings.ts';
import { openFiles } from './file-input.tsx';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createPhotoActions({ ui, masks, reading }: Pick<App, 'ui' | 'masks' | 'reading'>) {
  return {
    subjects: {
      label: strings.showSubjects,
      icon: 'subjects',
      on: ui.subjects,
      run: () => {
        ui.subjects.value = !ui.subjects.peek();
      },
    },
    stopMasks: { label: strings.stopMasking, icon: 'pause', run: masks.stop },
    goOnMasks: { label: strings.goOnMasking, icon: 'play', run: masks.goOn },
    add: { label: strings.addPhotos, icon: 'add', run: openFiles },
    choose: { label: strings.chooseFiles, icon: 'photos', run: openFiles },
    trySamples: { label: strings.trySamples, run: reading.addSamples },
  } satisfies Record<string, Action>;
}
