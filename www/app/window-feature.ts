/** State of the window, messages, and the engine with its scheduler. */

import { lazy } from '../ui/lazy.tsx';
import { createEngine } from '../engine/engine.ts';
import { createScheduler } from '../engine/scheduler.ts';
import { effect, untracked } from '@preact/signals';
import { createMessages } from '../ui/messages.ts';
import { isHandheld } from '../ui/media.ts';
import { createUi } from '../ui/ui.ts';
import { createWindowActions } from './window-actions.ts';
import type { Engine } from '../engine/engine.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Messages } from '../ui/messages.ts';
import type { Ui } from '../ui/ui.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  ui: Ui;
  messages: Messages;
  scheduler: Scheduler;
  engine: Engine;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ window: createWindowActions(app) });

export const windowFeature: Feature<Parts> = {
  install({ env: { window } }) {
    const scheduler = createScheduler();
    return {
      ui: createUi(window),
      messages: createMessages(),
      scheduler,
      engine: createEngine({ sparing: isHandheld(window), scheduler }),
    };
  },
  start({ ui, messages }) {
    // A workspace covers the page and its notes.
    effect(() => {
      if (ui.work.value !== null) untracked(messages.leaveNotes);
    });
  },
  onLeaveProject({ ui }) {
    ui.stack.value = null;
    ui.work.value = null;
  },
  screens: {
    board: lazy(async () => (await import('./board.tsx')).Board, { close: () => {} }),
  },
  actions,
};
