/** Hints. */

import { HelpDialog } from './help-dialog.tsx';
import { createHints } from './hints.ts';
import type { Hints } from './hints.ts';
import type { Feature } from '../ui/context.ts';

type Parts = {
  hints: Hints;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
}

export const helpFeature: Feature<Parts> = {
  install: (app) => ({ hints: createHints({ ...app, box: () => app.env.window.localStorage }) }),
  screens: {
    help: HelpDialog,
  },
};
