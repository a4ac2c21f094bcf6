/**
 * The wiring: creates all parts, connects them, and updates `document.body.dataset.idle`.
 */

import { createBoards, isComic } from '../boards/boards.ts';
import { createAnimatics } from '../motion/animatics.ts';
import './framed.ts';
import { computed, effect, untracked } from '@preact/signals';
import { render } from 'preact';
import { createEngine } from '../engine/engine.ts';
import { unreadMeta } from '../document/album.ts';
import { createAhead } from '../page/ahead.ts';
import { createAlternatives } from '../page/alternatives.ts';
import { createBook } from '../book/book.ts';
import { createBookMaking } from '../book/book-making.ts';
import { keepBook } from '../book/book-upkeep.ts';
import { createArrivals } from './arrivals.ts';
import { createBetterCrops } from '../page/better-crops.ts';
import { createChoosing } from '../photos/choosing.ts';
import { createDesigner } from '../designer/designer.ts';
import { createDownload } from '../export/download.ts';
import { createExportChoice } from '../export/export-choice.ts';
import { createDroppedFiles } from './dropped-files.ts';
import { createExplorer } from '../explorer/explorer.ts';
import { createKeeping } from '../storage/storage.ts';
import { createShelves } from '../storage/shelves.ts';
import { createFilmSounds } from '../lettering/film-sounds.ts';
import { createFraming } from '../page/panels/framing.ts';
import { createImitation } from '../imitation/imitation.ts';
import { createHints } from '../help/hints.ts';
import { createInstalling } from '../offline/installing.ts';
import { heroOf } from '../photos/hero.ts';
import { freshPhotoPrefix } from '../photos/intake.ts';
import { createKeys } from './keys.ts';
import { createLettering } from '../lettering/lettering.ts';
import { createNarrating } from '../lettering/narrating.ts';
import { createMerging } from '../page/panels/merging.ts';
import { reportFailure } from '../ui/importing.ts';
import { createMessages } from '../ui/messages.ts';
import { createOffline } from '../offline/offline.ts';
import { createOwnLayouts } from '../layouts/own-layouts.ts';
import { createOwnStyles, freshStyleId } from '../styles/own-styles.ts';
import { createPages, freshSeed } from '../document/pages.ts';
import { createPlaceNames } from '../photos/place-names.ts';
import { loadPlaces, locationOf } from '../engine/place-table.ts';
import { createReading } from '../photos/reading.ts';
import { offerRtl } from '../page/rtl-offer.ts';
import { createReshaping } from '../page/panels/reshaping.ts';
import { createScrubbing } from '../page/panels/scrubbing.ts';
import { createSelection } from '../page/panels/selection.ts';
import { createStore } from '../document/store.ts';
import { createShownPages } from '../book/shown-pages.ts';
import { createSubtitling } from '../lettering/subtitling.ts';
import { isStyleLink } from '../styles/style-link.ts';
import { createInventions } from '../explorer/inventions.ts';
import { createStyling } from '../styles/styling.ts';
import { createRecentStyles } from '../styles/recent-styles.ts';
import { createTaste } from '../styles/taste.ts';
import { createMasks } from '../photos/masks.ts';
import { createSubjects } from '../photos/subjects.ts';
import { isHandheld } from '../ui/media.ts';
import { createUi } from './ui.ts';
import { strings } from '../strings/strings.ts';
import { App } from './app.tsx';
import { AppContext } from '../ui/context.ts';
import { acceptFiles, dragging, expectFiles, forStyle } from './drop.ts';
import { trackPointed } from './pointed.ts';
import { holdSliders } from './slider-touch.ts';
import { drawn } from './guard.tsx';
import { keepFocus } from './focus-keeper.ts';
import { openFiles } from '../photos/file-input.tsx';
import { createActions } from './actions.ts';
import { enlarged } from '../page/panels/enlarging.ts';
import { explain } from '../ui/explain.ts';
import type { Parts } from '../ui/context.ts';

const engine = createEngine({ sparing: isHandheld(window) });
const ui = createUi(window);
const messages = createMessages();
const store = createStore({ onRefused: (error) => void messages.alert(strings.notDone(explain(error))) });
const pages = createPages(store, {
  asked: (wish) => taste.asked(styling.asked(wish)),
  narrated: (page, at) => narrating.narrated(page, at),
  settled: (page) => lettering.settled(page),
  shuffled: () => hints.shuffled(),
});
const placeNames = createPlaceNames({ locationOf, load: loadPlaces });
const reading = createReading({
  store,
  pages,
  engine,
  messages,
  prefix: freshPhotoPrefix(),
  detects: ui.detects,
  places: placeNames,
});
const book = createBook({ store, pages, messages, onKept: (page) => taste.learn(page) });
const choosing = createChoosing({ store, pages, reading, messages, enlarged });
const scrubbing = createScrubbing({ store, pages, reading, engine, messages });
const selection = createSelection({ store });
const narrating = createNarrating({
  store,
  ui,
  album: reading,
  settled: (page, only) => lettering.settled(page, only),
});
const lettering = createLettering({ store, messages, selection, load: engine.lettering });
const subtitling = createSubtitling({ store, lettering, messages });
const filmSounds = createFilmSounds({ store, engine, lettering, messages });
const merging = createMerging({ store, pages, selection });
const framing = createFraming({ store, pages });
const reshaping = createReshaping({ store, pages, seed: freshSeed });
const hints = createHints({ store, selection, lettering, framing, reshaping, ui, box: () => window.localStorage });
const ownLayouts = createOwnLayouts({ store, pages, messages });
const designer = createDesigner({ store, pages, messages, ui, freshId: freshStyleId });
const ownStyles = createOwnStyles({ store, messages, designer, freshId: freshStyleId });
const shelves = createShelves({ store, messages, box: () => window.localStorage });
const recentStyles = createRecentStyles(() => window.localStorage);
const taste = createTaste({ planner: () => store.planner.peek(), box: () => window.localStorage });
const shownPages = createShownPages({ store, pages, onLoved: taste.learn });
const views = {
  drawn: () => drawn(ui),
  retry: () => {
    ui.failed.value = null;
  },
};
const keeping = createKeeping({
  store,
  reading,
  engine,
  shelves,
  messages,
  window,
  leave,
  chooseFiles: openFiles,
  views,
});
const explorer = createExplorer({ store, engine, messages, ownStyles, seed: freshSeed, judged: ui.detects });
const imitation = createImitation({ store, engine, messages, ui, seed: freshSeed, freshId: freshStyleId });
const inventions = createInventions({
  store,
  engine,
  seed: freshSeed,
  judged: ui.detects,
  // After the subjects: two models at a time exceed the memory of a tab on small devices.
  idle: () => ui.painted.value === store.page.value && subjects.settled.value && masks.settled.value,
});
const styling = createStyling({ store, ownStyles, inventions: () => inventions.ready.peek() });
const crops = createBetterCrops({ store, pages, ui });
const subjects = createSubjects({
  store,
  messages,
  engine,
  painted: () => ui.painted.value === store.page.value,
  onFound: () => {
    crops.found();
    narrating.avoidFaces();
  },
  wanted: ui.detects,
  window,
});
const bookMaking = createBookMaking({
  store,
  book,
  pages,
  album: reading,
  searched: () => !ui.detects || (subjects.searched.peek() && subjects.settled.peek()),
  ready: () => Promise.all([lettering.ready(), placeNames.settled()]),
});
effect(() => {
  if (placeNames.names.value.size > 0 && !store.sketch.value) untracked(narrating.renew);
});
offerRtl({ store, pages, messages, language: window.navigator.language });
const boards = createBoards({ store, engine, chooseStyle: pages.chooseStyle });
const animatics = createAnimatics({ store, engine, boards });
const masks = createMasks({
  store,
  engine,
  onFound: crops.found,
  ready: () =>
    store.reading.value === null && ui.painted.value === store.page.value && subjects.settled.value && !taking.value,
  wanted: ui.detects,
});
const download = createDownload({
  store,
  pages,
  engine,
  messages,
  pageFiles: keeping.pageFiles,
  shotList: boards.shotList,
  animatics,
  // Storyboard sheets do not count as preferred layouts.
  onSaved: (saved) => saved.filter(isComic).forEach(taste.learn),
});
const exportChoice = createExportChoice(() => window.localStorage);
const alternatives = createAlternatives({ store, pages });
const ahead = createAhead({ store, pages, ui });
const installing = createInstalling(window);
const {
  take: intake,
  openProjects,
  busy: taking,
} = createDroppedFiles({
  store,
  keeping,
  reading,
  subtitling,
  messages,
  ownLayouts,
  ownStyles,
  showProjects: () => {
    ui.work.value = 'projects';
  },
});
const arrivals = createArrivals({ window, intake, messages });

// The database is read while the core is compiled.
const begun = keeping.begin();
engine.ready.then(
  (planner) => {
    store.planner.value = planner;
    shelves.recall();
    void begun.then(openLink);
    void begun.then(arrivals.begin);
    setTimeout(warmUp);
  },
  (error) => {
    keeping.running.value = false;
    messages.grave(strings.coreFailed(explain(error)));
  },
);

/** Reads the catalogues and compiles the code while the app is idle, so that the first page does not wait for them. */
function warmUp() {
  store.layouts.peek();
  store.styles.peek();
  const planner = store.planner.peek();
  if (!planner) return;
  const keep = { layout: false, style: false, photos: false };
  const plan = (seed: number) =>
    planner.plan({ seed, photos: [unreadMeta('warm')], page: store.project.peek().settings, current: null, keep });
  void engine.warm([0, 1, 2, 3].map(plan));
}

const parts: Parts = {
  store,
  pages,
  crops,
  boards,
  animatics,
  book,
  bookMaking,
  selection,
  lettering,
  narrating,
  subtitling,
  filmSounds,
  intake,
  openProjects,
  installing,
  merging,
  framing,
  reshaping,
  hints,
  ownLayouts,
  designer,
  ownStyles,
  styling,
  taste,
  recentStyles,
  explorer,
  imitation,
  keeping,
  shownPages,
  subjects,
  masks,
  reading,
  ahead,
  choosing,
  scrubbing,
  download,
  exportChoice,
  alternatives,
  messages,
  ui,
  engine,
};
const actions = createActions(parts);
window.addEventListener(
  'keydown',
  createKeys({
    actions,
    ui,
    leave: leaveMode,
    covered: () => document.querySelector('dialog:modal') !== null,
    pointed: trackPointed(window),
  }),
);
acceptFiles(window, {
  accept: (files) => void intake(files),
  imitate: imitation.take,
  unread: (name, error) => reportFailure(messages, name, error),
});
// A picture that is dragged to the style search will arrive soon, so the survey starts. If the drag is cancelled, the
// next search uses the survey.
effect(() => {
  if (!dragging.value || !forStyle.value) return;
  const photo = untracked(() => imitation.photo.value ?? heroOf({ store, engine }));
  if (photo !== null) imitation.prepare(photo);
});
expectFiles(window, subjects.expect);
holdSliders(window);

/** Whether an urgent task is running, which idle work must not delay. */
const busy = () =>
  store.planner.value === null ||
  store.reading.value !== null ||
  store.fetching.value ||
  lettering.loading.value ||
  keeping.running.value ||
  keeping.turning.value ||
  keeping.files.progress.value !== null ||
  taking.value;
if (import.meta.env.PROD)
  createOffline({ window, messages, keeping, script: import.meta.url, busy: () => busy() || !subjects.settled.value });

window.addEventListener('hashchange', openLink);
window.addEventListener('storage', shelves.hear);

effect(() => {
  if (store.page.value && ui.painted.value === store.page.value) keeping.drawn();
});

// The fields of a selected text item are in the tab Text.
effect(() => {
  if (lettering.chosen.value >= 0 && ui.wide.peek()) ui.sideTab.value = 'words';
});

effect(() => {
  const page = store.page.value;
  // A page without photos to choose from is not shown.
  const unseen = page === null || store.tray.value.length === 0 || ui.failed.value !== null;
  const painted =
    unseen ||
    (ui.painted.value === page &&
      (lettering.words.value.length === 0 || reshaping.editing.value || ui.lettered.value === page));
  const idle = !busy() && painted;
  document.body.dataset.idle = String(idle);
  // The first page of a large album is drawn long before all photos are read.
  const read = store.page.value?.panels.every(({ photo }) => photo === null || store.album.value.get(photo)?.meta);
  document.body.dataset.drawn = String(painted && !!read);
  document.body.dataset.sketched = String(store.sketch.value && store.thumbnails.value.size > 0);
  // Detection improves an existing page, so it has a separate state.
  document.body.dataset.searched = String(idle && subjects.searched.value);
  document.body.dataset.detected = String(idle && subjects.settled.value);
  document.body.dataset.masked = String(idle && subjects.settled.value && masks.settled.value);
});

effect(() => {
  const page = store.page.value;
  const drawing = page !== null && ui.painted.value !== page && ui.failed.value === null;
  engine.hold(reading.near.value || drawing);
});

keepBook({ store, pages });
// Unfinished edits of a page end when another page opens.
book.sheet.subscribe(() => untracked(leavePage));

render(
  <AppContext.Provider value={{ ...parts, actions }}>
    <App />
  </AppContext.Provider>,
  document.getElementById('app') as HTMLElement,
);

keepFocus(document.getElementById('app') as HTMLElement);

/** Applies the style of the address, and removes it from the address. */
function openLink() {
  const { hash } = window.location;
  if (!isStyleLink(hash)) return;
  window.history.replaceState(null, '', window.location.href.slice(0, -hash.length));
  void ownStyles.openLink(hash);
}

/** A workspace covers the page and its notes. */
effect(() => {
  if (ui.work.value !== null) untracked(messages.leaveNotes);
});

/** The action of Escape: closes the mode that was opened last. */
function leaveMode() {
  if (ui.originals.peek()) return () => void (ui.originals.value = false);
  if (ui.preview.peek()) return () => void (ui.preview.value = false);
  if (framing.placing.peek() !== null) return () => framing.place(null);
  if (lettering.mode.peek()) return () => void (lettering.mode.value = null);
  if (framing.mode.peek()) return () => void (framing.mode.value = null);
  if (lettering.chosen.peek() >= 0) return () => lettering.choose(-1);
  if (framing.cropping.peek() !== null) return () => void (framing.cropping.value = null);
  if (selection.several.peek() || selection.panels.peek().length > 0) return () => selection.choose(false);
  if (reshaping.editing.peek()) return () => void (reshaping.editing.value = false);
  if (ui.sheet.peek()) return () => void (ui.sheet.value = null);
  return hints.shown.peek() ? hints.close : undefined;
}

/** One thing is selected at a time: panels or a text item. */
effect(() => {
  if (lettering.chosen.value >= 0) untracked(selection.clear);
});
effect(() => {
  if (selection.panels.value.length === 0) return;
  untracked(() => lettering.choose(-1));
});
/** Keys act on a focused text item, so the focus leaves a text item that is not selected any more. */
effect(() => {
  if (lettering.chosen.value >= 0) return;
  const focused = document.activeElement;
  if (focused instanceof HTMLElement && focused.matches('.word, .word-tail, .word-handle')) focused.blur();
});
/** Modes of a panel end with its selection. */
effect(() => {
  const [panel, other] = selection.panels.value;
  const { mode, cropping } = framing;
  if (cropping.peek() !== null && (cropping.peek() !== panel || other !== undefined)) cropping.value = null;
  if (mode.peek()?.kind === 'replace' && mode.peek()?.panel !== panel) mode.value = null;
});
/** Another version of the page, and the page in full screen, begin without a selection. */
const pageId = computed(() => store.project.value.pageId);
effect(() => {
  void pageId.value;
  untracked(() => lettering.choose(-1));
});
effect(() => {
  if (!ui.preview.value) return;
  untracked(() => {
    selection.choose(false);
    lettering.choose(-1);
  });
});

/** Closes everything that belongs to the previous page. */
function leavePage() {
  framing.place(null);
  framing.mode.value = null;
  reshaping.editing.value = false;
  selection.choose(false);
  lettering.choose(-1);
}

/** Closes everything that belongs to the previous project. */
function leave() {
  leavePage();
  explorer.stop();
  imitation.clear();
  ui.stack.value = null;
  ui.work.value = null;
}
