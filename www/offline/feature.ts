/** Offline use, and the installed app. */

import { createInstalling } from './installing.ts';
import { createOffline } from './offline.ts';
import type { Installing } from './installing.ts';
import type { Feature } from '../ui/context.ts';

type Parts = {
  installing: Installing;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
}

export const offlineFeature: Feature<Parts> = {
  install: ({ env }) => ({ installing: createInstalling(env.window) }),
  start(app) {
    const { env, busy, subjects } = app;
    if (import.meta.env.PROD) createOffline({ ...app, ...env, busy: () => busy() || !subjects.settled.value });
  },
};
