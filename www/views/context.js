// @ts-check
/**
 * What every view may reach: the state, what can be done to it, and the engine. Wired in `main.jsx` only.
 */

import { createContext } from 'preact';
import { useContext } from 'preact/hooks';

/**
 * @typedef {{
 *   store: import('../state/store.js').Store,
 *   pages: import('../state/pages.js').Pages,
 *   book: import('../state/book.js').Book,
 *   subjects: import('../state/subjects.js').Subjects,
 *   reading: import('../state/reading.js').Reading,
 *   scrubbing: import('../state/scrubbing.js').Scrubbing,
 *   choosing: import('../state/choosing.js').Choosing,
 *   selection: import('../state/selection.js').Selection,
 *   merging: import('../state/merging.js').Merging,
 *   lettering: import('../state/lettering.js').Lettering,
 *   subtitling: import('../state/subtitling.js').Subtitling,
 *   intake: (files: File[]) => void,
 *   openProjects: (files: File[]) => void,
 *   installing: import('../state/installing.js').Installing,
 *   framing: import('../state/framing.js').Framing,
 *   reshaping: import('../state/reshaping.js').Reshaping,
 *   ownLayouts: import('../state/own-layouts.js').OwnLayouts,
 *   designer: import('../state/designer.js').Designer,
 *   ownStyles: import('../state/own-styles.js').OwnStyles,
 *   explorer: import('../state/explorer.js').Explorer,
 *   styling: import('../state/styling.js').StylingDeeds,
 *   keeping: import('../state/keeping/keeping.js').Keeping,
 *   shownPages: import('../state/shown-pages.js').ShownPages,
 *   download: import('../state/download.js').Download,
 *   alternatives: import('../state/alternatives.js').Alternatives,
 *   messages: import('../state/messages.js').Messages,
 *   ui: import('../state/ui.js').Ui,
 *   engine: import('../engine/engine.js').Engine,
 * }} App
 */

export const AppContext = createContext(/** @type {App | null} */ (null));

/** @returns {App} */
export function useApp() {
  const app = useContext(AppContext);
  if (!app) throw new Error('A view was rendered outside of AppContext.');
  return app;
}
