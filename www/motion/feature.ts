/** Videos of storyboards and pages. */

import { createAnimatics } from './animatics.ts';
import type { Animatics } from './animatics.ts';
import type { Feature } from '../ui/context.ts';

type Parts = {
  animatics: Animatics;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
}

export const motionFeature: Feature<Parts> = {
  install: (app) => ({ animatics: createAnimatics(app) }),
};
