/** Files that are dropped, pasted, chosen or sent by the system. */

import { effect, untracked } from '@preact/signals';
import { heroOf } from '../photos/hero.ts';
import { reportFailure } from '../ui/importing.ts';
import { warmPlanner } from './begin.ts';
import { acceptFiles, dragging, expectFiles, forStyle } from './drop.ts';
import { createDroppedFiles } from './dropped-files.ts';
import type { Feature } from '../ui/context.ts';

type Parts = {
  droppedFiles: ReturnType<typeof createDroppedFiles>;
  intake: (files: File[]) => void;
  openProjects: (files: File[]) => void;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
}

export const filesFeature: Feature<Parts> = {
  install(app) {
    const showProjects = () => {
      app.ui.work.value = 'projects';
    };
    const droppedFiles = createDroppedFiles({ ...app, showProjects });
    return { droppedFiles, intake: droppedFiles.take, openProjects: droppedFiles.openProjects };
  },
  start(app) {
    const { intake, imitation, messages, store, engine, subjects, env } = app;
    const { window } = env;
    acceptFiles(window, {
      accept: (files) => void intake(files),
      imitate: imitation.take,
      unread: (name, error) => reportFailure(messages, name, error),
    });
    // A picture that is dragged to the style search will arrive soon, so the survey starts. If the drag is cancelled,
    // the next search uses the survey.
    effect(() => {
      if (!dragging.value || !forStyle.value) return;
      const photo = untracked(() => imitation.photo.value ?? heroOf({ store, engine }));
      if (photo !== null) imitation.prepare(photo);
    });
    let isWarm = false;
    expectFiles(window, () => {
      subjects.expect();
      if (!isWarm && store.tray.peek().length === 0) warmPlanner(app);
      isWarm = true;
    });
  },
  busy: ({ droppedFiles }) => droppedFiles.busy.value,
};
