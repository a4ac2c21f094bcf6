/** Styles of the user, and the preferences of Shuffle. */

import { freshStyleId, createOwnStyles } from './own-styles.ts';
import { createRecentStyles } from './recent-styles.ts';
import { createStyleActions } from './style-actions.ts';
import { isStyleLink } from './style-link.ts';
import { createStyling } from './styling.ts';
import { createTaste } from './taste.ts';
import type { OwnStyles } from './own-styles.ts';
import type { RecentStyles } from './recent-styles.ts';
import type { StylingDeeds } from './styling.ts';
import type { Taste } from './taste.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  ownStyles: OwnStyles;
  recentStyles: RecentStyles;
  taste: Taste;
  styling: StylingDeeds;
  /** Applies the style of the address, and removes it from the address. */
  openStyleLink: () => void;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ styles: createStyleActions(app) });

export const stylesFeature: Feature<Parts> = {
  install(app) {
    const { window } = app.env;
    const box = () => window.localStorage;
    const ownStyles = createOwnStyles({ ...app, freshId: freshStyleId });
    return {
      ownStyles,
      recentStyles: createRecentStyles(box),
      taste: createTaste({ planner: () => app.store.planner.peek(), box }),
      styling: createStyling({ ...app, ownStyles, inventions: () => app.inventions.ready.peek() }),
      openStyleLink() {
        const { hash, href } = window.location;
        if (!isStyleLink(hash)) return;
        window.history.replaceState(null, '', href.slice(0, -hash.length));
        void ownStyles.openLink(hash);
      },
    };
  },
  start: ({ openStyleLink, env: { window } }) => window.addEventListener('hashchange', openStyleLink),
  actions,
};
