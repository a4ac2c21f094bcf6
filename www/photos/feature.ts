/** Import of photos, and detection of their subjects. */

import { loadPlaces, locationOf } from '../engine/place-table.ts';
import { freshPhotoPrefix } from './intake.ts';
import { createMasks } from './masks.ts';
import { createPhotoActions } from './photo-actions.ts';
import { createPlaceNames } from './place-names.ts';
import { createReading } from './reading.ts';
import { createRotating } from './rotating.ts';
import { planAgain } from './second-plan.ts';
import { createSubjects } from './subjects.ts';
import type { Masks } from './masks.ts';
import type { Reading } from './reading.ts';
import type { Rotating } from './rotating.ts';
import type { Subjects } from './subjects.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  placeNames: ReturnType<typeof createPlaceNames>;
  reading: Reading;
  rotating: Rotating;
  subjects: Subjects;
  masks: Masks;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ photos: createPhotoActions(app) });

export const photosFeature: Feature<Parts> = {
  install(app) {
    const { store, ui, env } = app;
    const placeNames = createPlaceNames({ locationOf, load: loadPlaces, wanted: ui.places });
    const wanted = ui.detects;
    const reading = createReading({ ...app, prefix: freshPhotoPrefix(), detects: wanted, places: placeNames });
    // An export has all cores. Detection continues after it.
    const painted = () => ui.painted.value === store.page.value && app.download.progress.value === null;
    const onFound = () => {
      app.crops.found();
      app.narrating.avoidFaces();
      // A page that the user has seen keeps its photos, even if a near-duplicate is better.
      if (!store.sketch.peek() && reading.composed.peek() === null) reading.keepShown();
    };
    const { composed, keepShown } = reading;
    const unsettled = () => composed.value !== null;
    const subjects = createSubjects({ ...app, painted, unsettled, onFound, wanted, window: env.window });
    const { faced, searched } = subjects;
    if (wanted) planAgain({ ...app, composed, keepShown, faced, searched, window: env.window });
    const ready = () =>
      store.reading.value === null && painted() && subjects.settled.value && !app.droppedFiles.busy.value;
    const masks = createMasks({ ...app, onFound: () => app.crops.found(), ready, wanted });
    const rotating = createRotating({ ...app, reading });
    return { placeNames, reading, rotating, subjects, masks };
  },
  busy: ({ rotating }) => rotating.busy(),
  actions,
};
