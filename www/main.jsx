// @ts-check
/**
 * The wiring: makes the parts, joins them, and keeps `document.body.dataset.idle` true to its word.
 */

import './framed.js';
import { effect, untracked } from '@preact/signals';
import { render } from 'preact';
import { createEngine } from './engine/engine.js';
import { unreadMeta } from './state/album.js';
import { createAlternatives } from './state/alternatives.js';
import { createBook } from './state/book.js';
import { keepBook } from './state/book-upkeep.js';
import { createArrivals } from './state/arrivals.js';
import { createChoosing } from './state/choosing.js';
import { createDesigner } from './state/designer.js';
import { createDownload } from './state/download.js';
import { createDroppedFiles } from './state/dropped-files.js';
import { createExplorer } from './state/explorer.js';
import { createKeeping } from './state/keeping/keeping.js';
import { createShelves } from './state/keeping/shelves.js';
import { createFraming } from './state/framing.js';
import { createInstalling } from './state/installing.js';
import { freshPhotoPrefix } from './state/intake.js';
import { createKeys } from './state/keys.js';
import { createLettering } from './state/lettering.js';
import { createMerging } from './state/merging.js';
import { createMessages } from './state/messages.js';
import { createOffline } from './state/offline.js';
import { createOwnLayouts } from './state/own-layouts.js';
import { createOwnStyles, freshStyleId } from './state/own-styles.js';
import { createPages, freshSeed } from './state/pages.js';
import { createReading } from './state/reading.js';
import { createReshaping } from './state/reshaping.js';
import { createScrubbing } from './state/scrubbing.js';
import { createSelection } from './state/selection.js';
import { createStore } from './state/store.js';
import { createShownPages } from './state/shown-pages.js';
import { createSubtitling } from './state/subtitling.js';
import { isStyleLink } from './state/style-link.js';
import { createStyling } from './state/styling.js';
import { createSubjects } from './state/subjects.js';
import { createUi } from './state/ui.js';
import { strings } from './strings.js';
import { App } from './views/app.jsx';
import { AppContext } from './views/context.js';
import { acceptFiles } from './views/drop.js';
import { drawn } from './views/guard.jsx';
import { keepFocus } from './views/focus-keeper.js';
import { openFiles } from './views/file-input.jsx';

const engine = createEngine();
const store = createStore();
const ui = createUi(window);
const messages = createMessages();
const pages = createPages(store);
const reading = createReading({ store, pages, engine, messages, prefix: freshPhotoPrefix() });
const book = createBook({ store, pages, messages });
const choosing = createChoosing({ store, pages, reading });
const scrubbing = createScrubbing({ store, pages, reading, engine, messages });
const selection = createSelection({ store });
const lettering = createLettering({ store, messages, selection, load: engine.lettering });
const subtitling = createSubtitling({ store, lettering, messages });
const merging = createMerging({ store, pages, selection });
const framing = createFraming({ store, pages });
const reshaping = createReshaping({ store, pages, seed: freshSeed });
const ownLayouts = createOwnLayouts({ store, pages, messages });
const designer = createDesigner({ store, pages, messages, ui, freshId: freshStyleId });
const ownStyles = createOwnStyles({ store, pages, messages, designer, freshId: freshStyleId });
const shelves = createShelves({ store, messages, box: () => window.localStorage });
const shownPages = createShownPages({ store, pages });
const views = { drawn: () => drawn(ui), retry: () => { ui.failed.value = null; } };
const keeping = createKeeping({ store, reading, engine, shelves, messages, window, leave, chooseFiles: openFiles, views });
const explorer = createExplorer({ store, engine, messages, ownStyles, seed: freshSeed, judged: ui.detects });
const styling = createStyling({ store, ownStyles });
const subjects = createSubjects({
  store, pages, messages, engine, painted: () => ui.painted.value === store.page.value, wanted: ui.detects, window,
});
const download = createDownload({ store, pages, engine, messages, pageFiles: keeping.pageFiles });
const alternatives = createAlternatives({ store, pages });
const installing = createInstalling(window);
const { take: intake, openProjects, busy: taking } = createDroppedFiles({ store, keeping, reading, subtitling, messages, ownLayouts, ownStyles, showProjects: () => { ui.work.value = 'projects'; } });
const arrivals = createArrivals({ window, intake, messages });

// The database is read while the core is compiled.
const begun = keeping.begin();
engine.ready.then(
  (planner) => {
    store.planner.value = lettering.within(styling.within(planner));
    shelves.recall();
    void begun.then(openLink);
    void begun.then(arrivals.begin);
    setTimeout(warmUp);
  },
  (error) => {
    keeping.running.value = false;
    messages.grave(strings.coreFailed(error.message));
  },
);

/** Reads the catalogues and has the planner compiled while nobody waits; the first page would else wait for both. */
function warmUp() {
  store.layouts.peek();
  store.styles.peek();
  const keep = { layout: false, style: false, photos: false };
  store.planner.peek()?.plan({ seed: 0, photos: [unreadMeta('none')], page: store.project.peek().settings, current: null, keep });
}

window.addEventListener('keydown', createKeys({ pages, download, ui, selection, framing, reshaping, book, lettering }));
acceptFiles(window, intake);

/** Whether something is on its way that nobody should wait for longer than need be. */
const busy = () => store.planner.value === null || store.reading.value !== null || store.fetching.value || keeping.running.value || keeping.turning.value ||
  keeping.files.progress.value !== null || taking.value;
if (import.meta.env.PROD) createOffline({ window, messages, keeping, script: import.meta.url, busy: () => busy() || !subjects.settled.value });

window.addEventListener('hashchange', openLink);
window.addEventListener('storage', shelves.hear);

effect(() => {
  if (store.page.value && ui.painted.value === store.page.value) keeping.drawn();
});

effect(() => {
  const page = store.page.value;
  // A page without photos to choose from is not shown.
  const unseen = page === null || store.tray.value.length === 0 || ui.failed.value !== null;
  const painted = unseen || (ui.painted.value === page && (lettering.words.value.length === 0 || reshaping.editing.value || ui.lettered.value === page));
  const idle = !busy() && painted;
  document.body.dataset.idle = String(idle);
  // Of a large album the first page is drawn long before all is read.
  const read = store.page.value?.panels.every(({ photo }) => photo === null || store.album.value.get(photo)?.meta);
  document.body.dataset.drawn = String(painted && !!read);
  // Detection refines what is there already, so it is told apart.
  document.body.dataset.searched = String(idle && subjects.searched.value);
  document.body.dataset.detected = String(idle && subjects.settled.value);
});

keepBook({ store, pages });
// What was begun on a page ends when another is turned to.
book.sheet.subscribe(() => untracked(leavePage));

render(
  <AppContext.Provider value={{ store, pages, book, selection, lettering, subtitling, intake, openProjects, installing, merging, framing, reshaping, ownLayouts, designer, ownStyles, styling, explorer, keeping, shownPages, subjects, reading, choosing, scrubbing, download, alternatives, messages, ui, engine }}>
    <App />
  </AppContext.Provider>,
  /** @type {HTMLElement} */ (document.getElementById('app')),
);

keepFocus(/** @type {HTMLElement} */ (document.getElementById('app')));

/** Takes the style of the address, which then stands for the page alone again. */
function openLink() {
  const { hash } = window.location;
  if (!isStyleLink(hash)) return;
  window.history.replaceState(null, '', window.location.href.slice(0, -hash.length));
  void ownStyles.openLink(hash);
}

/** Closes what belongs to the page before. */
function leavePage() {
  framing.mode.value = null;
  reshaping.editing.value = false;
  selection.choose(false);
  lettering.choose(-1);
}

/** Closes what belongs to the project before. */
function leave() {
  leavePage();
  explorer.stop();
  ui.stack.value = null;
  ui.work.value = null;
}
