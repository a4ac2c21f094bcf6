/** Models of painters of the user. */

import { effect, untracked } from '@preact/signals';
import { openFiles } from '../photos/file-input.tsx';
import { strings } from '../strings/strings.ts';
import { createModelShelf } from './model-shelf.ts';
import { createOwnPainters } from './own-painters.ts';
import { partsOf } from './references.ts';
import type { OwnPainters } from './own-painters.ts';
import type { Feature } from '../ui/context.ts';

type Parts = { ownPainters: OwnPainters };

declare module '../ui/context.ts' {
  interface App extends Parts {}
}

export const paintersFeature: Feature<Parts> = {
  install(app) {
    const ownPainters = createOwnPainters({ ...app, shelf: createModelShelf() });
    app.engine.ownPaintersFrom(ownPainters.files);
    return { ownPainters };
  },
  start({ ownPainters, messages }) {
    /** The models that the message names. */
    let told = { names: '', message: 0 };
    effect(() => {
      const names = strings.listed(ownPainters.missing.value.map((reference) => partsOf(reference).name));
      if (names === told.names) return;
      untracked(() => {
        messages.close(told.message);
        const way = { label: strings.addModel, run: openFiles };
        told = { names, message: names === '' ? 0 : messages.offer(strings.styleLacksModel({ names }), way) };
      });
    });
  },
};
