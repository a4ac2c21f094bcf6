/** Text on pages, from the user, from subtitles and from sounds. */

import { computed, effect, untracked } from '@preact/signals';
import { createFilmSounds } from './film-sounds.ts';
import { createLettering } from './lettering.ts';
import { createNarrating } from './narrating.ts';
import { createSpeakers } from './speakers.ts';
import { createSubtitling } from './subtitling.ts';
import { createTextActions, createWordActions } from './word-actions.ts';
import type { FilmSounds } from './film-sounds.ts';
import type { Lettering } from './lettering.ts';
import type { Narrating } from './narrating.ts';
import type { Subtitling } from './subtitling.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  lettering: Lettering;
  narrating: Narrating;
  subtitling: Subtitling;
  filmSounds: FilmSounds;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ words: createWordActions(app), text: createTextActions(app) });

export const letteringFeature: Feature<Parts> = {
  install(app) {
    const lettering = createLettering({ ...app, load: app.engine.lettering });
    return {
      lettering,
      narrating: createNarrating({
        ...app,
        album: app.reading,
        placed: app.placeNames.marked,
        settled: lettering.settled,
        cleared: lettering.cleared,
      }),
      subtitling: createSubtitling({ ...app, lettering }),
      filmSounds: createFilmSounds({ ...app, lettering }),
    };
  },
  start(app) {
    const { store, ui, lettering, narrating, selection, placeNames, subjects } = app;
    const ready = () => store.reading.value === null && ui.painted.value === store.page.value && subjects.settled.value;
    createSpeakers({ ...app, settled: lettering.settled, ready });
    effect(() => {
      if (placeNames.names.value.size > 0 && !store.sketch.value) untracked(narrating.renew);
    });
    // The fields of a selected text item are in the tab Text.
    effect(() => {
      if (lettering.chosen.value >= 0 && ui.wide.peek()) ui.sideTab.value = 'words';
    });
    // One thing is selected at a time: panels or a text item.
    effect(() => {
      if (lettering.chosen.value >= 0) untracked(selection.clear);
    });
    effect(() => {
      if (selection.panels.value.length > 0) untracked(() => lettering.choose(-1));
    });
    // Keys act on a focused text item, so the focus leaves a text item that is not selected any more.
    effect(() => {
      if (lettering.chosen.value >= 0) return;
      const focused = document.activeElement;
      if (focused instanceof HTMLElement && focused.matches('.word, .word-tail, .word-handle')) focused.blur();
    });
    // Another version of the page, and the page in full screen, begin without a selection.
    const pageId = computed(() => store.project.value.pageId);
    effect(() => {
      void pageId.value;
      untracked(() => lettering.choose(-1));
    });
    effect(() => {
      if (ui.preview.value) untracked(() => lettering.choose(-1));
    });
  },
  busy: ({ lettering }) => lettering.loading.value,
  onLeavePage: ({ lettering }) => lettering.choose(-1),
  actions,
};
