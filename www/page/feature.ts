/** The open page: its panels, and proposals for other pages. */

import { effect, untracked } from '@preact/signals';
import { createChoosing } from '../photos/choosing.ts';
import { createAhead } from './ahead.ts';
import { createAlternatives } from './alternatives.ts';
import { createBetterCrops } from './better-crops.ts';
import { createPageActions } from './page-actions.ts';
import { createFraming } from './panels/framing.ts';
import { createMerging } from './panels/merging.ts';
import { createPanelActions } from './panels/panel-actions.ts';
import { createReshaping } from './panels/reshaping.ts';
import { createScrubbing } from './panels/scrubbing.ts';
import { createSelection } from './panels/selection.ts';
import { offerRtl } from './rtl-offer.ts';
import { freshSeed } from '../document/pages.ts';
import type { Choosing } from '../photos/choosing.ts';
import type { Ahead } from './ahead.ts';
import type { Alternatives } from './alternatives.ts';
import type { BetterCrops } from './better-crops.ts';
import type { Framing } from './panels/framing.ts';
import type { Merging } from './panels/merging.ts';
import type { Reshaping } from './panels/reshaping.ts';
import type { Scrubbing } from './panels/scrubbing.ts';
import type { Selection } from './panels/selection.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  selection: Selection;
  framing: Framing;
  merging: Merging;
  reshaping: Reshaping;
  scrubbing: Scrubbing;
  choosing: Choosing;
  crops: BetterCrops;
  alternatives: Alternatives;
  ahead: Ahead;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ page: createPageActions(app), panels: createPanelActions(app) });

export const pageFeature: Feature<Parts> = {
  install(app) {
    const selection = createSelection(app);
    return {
      selection,
      framing: createFraming(app),
      merging: createMerging({ ...app, selection }),
      reshaping: createReshaping({ ...app, seed: freshSeed }),
      scrubbing: createScrubbing(app),
      choosing: createChoosing(app),
      crops: createBetterCrops(app),
      alternatives: createAlternatives(app),
      ahead: createAhead(app),
    };
  },
  start({ store, ui, pages, messages, selection, framing, env: { window } }) {
    offerRtl({ store, pages, messages, language: window.navigator.language });
    // Modes of a panel end with its selection.
    effect(() => {
      const [panel, other] = selection.panels.value;
      const { mode, cropping } = framing;
      if (cropping.peek() !== null && (cropping.peek() !== panel || other !== undefined)) cropping.value = null;
      if (mode.peek()?.kind === 'replace' && mode.peek()?.panel !== panel) mode.value = null;
    });
    // The page in full screen has no selection.
    effect(() => {
      if (ui.preview.value) untracked(() => selection.choose(false));
    });
  },
  onLeavePage({ framing, reshaping, selection }) {
    framing.place(null);
    framing.mode.value = null;
    reshaping.editing.value = false;
    selection.choose(false);
  },
  actions,
};
