// @ts-check
/**
 * Nothing is lost: the parts that keep the work of a person, joined.
 *
 * - `database.js` the tables; `versions.js` checks and migrates what comes out of them, or out of a file
 * - `snapshot.js` what of the session is kept; `photo-records.js` photos; `saving.js` when and how; `journal.js` the last edits
 * - `restoring.js` the way back; `rehearsing.js` tries a project before it is shown; `opening.js` which project is on the page
 *   (`last-project.js` at first), and which cannot be; `rescue.js` makes a file of that; `projects.js` the list of them
 * - `drawn-states.js` the last states that were drawn, to go back to
 * - `pictures.js` its thumbnails; `sweeping.js` throws away what no project needs, a day after (`orphans.js`)
 * - `locks.js` keeps tabs apart; `shelves.js` holds what all projects share
 * - `archive.js` ZIP files; `project-file.js` a project as one of them; `file-opening.js` opens a file of any kind
 * - `page-files.js` PNGs that carry their project: `page-json.js` what they tell, `page-file.js` where in the PNG it is
 * - `identity.js` how a photo is recognised; `found-photos.js` looks for it here; `absent-photos.js` waits for it
 *
 * The document is plain data and is saved whole: a field that is added to it needs nothing here.
 */

import { effect } from '@preact/signals';
import { failure } from '../../engine/protocol.js';
import { strings } from '../../strings.js';
import { save as saveFile } from '../files.js';
import { createAbsentPhotos } from './absent-photos.js';
import { openDatabase } from './database.js';
import { createDrawnStates } from './drawn-states.js';
import { createFileOpening } from './file-opening.js';
import { createJournal } from './journal.js';
import { createLastProject } from './last-project.js';
import { createLocks } from './locks.js';
import { createOpening } from './opening.js';
import { createPageFiles } from './page-files.js';
import { createPhotoRecords } from './photo-records.js';
import { createPictures } from './pictures.js';
import { createProjectFiles } from './project-file.js';
import { createProjects } from './projects.js';
import { rescued } from './rescue.js';
import { createSaving } from './saving.js';
import { sweep } from './sweeping.js';

/** @typedef {ReturnType<typeof createKeeping>} Keeping */

/** Milliseconds after the start until what nobody needs is thrown away. */
const SWEEP_AFTER = 8_000;
/** Milliseconds until a database that was closed from outside is looked at: whoever closed it comes first. */
const LOOK_AFTER = 300;

/**
 * @param {{
 *   store: import('../store.js').Store, reading: import('../reading.js').Reading, engine: import('../../engine/engine.js').Engine,
 *   shelves: import('./shelves.js').Shelves, messages: import('../messages.js').Messages, window: Window, leave: () => void,
 *   chooseFiles?: () => void, views?: import('./opening.js').Views,
 * }} app `chooseFiles` opens the browser's file dialog
 */
export function createKeeping({ store, reading, engine, shelves, messages, window, leave, chooseFiles = () => {}, views }) {
  const { navigator } = window;
  const locks = createLocks(navigator.locks);
  const last = createLastProject({ tab: () => window.sessionStorage, browser: () => window.localStorage });
  const records = createPhotoRecords({ photos: engine.photos, originals: store.originals });
  const pictures = createPictures({ store, engine, database, onDrawn: () => void projects.refresh().catch(() => {}) });
  const drawnStates = createDrawnStates({ store });
  const journal = createJournal({ box: () => window.localStorage });
  const saving = createSaving({ store, records, journal, locks, database, drawnStates, onTrouble, onWritten, onSaved });
  const opening = createOpening({
    store, reading, engine, shelves, saving, records, locks, messages, database, journal, last, drawnStates, leave, views,
    onMissing: (photos) => tellMissing(photos), onUnwritten: (names) => void (names.length > 0 && messages.grave(strings.photosNeverSaved(names), choose)),
  });
  const projects = createProjects({ store, opening, saving, locks, messages, database });
  const fileOpening = createFileOpening({ engine, messages, opening });
  const files = { ...createProjectFiles({ store, engine, messages, saving, fileOpening }), progress: fileOpening.progress, cancel: fileOpening.cancel, stops: fileOpening.stops };
  const choose = { label: strings.choosePhotos, run: chooseFiles };
  const absentPhotos = createAbsentPhotos({ store, engine, reading, messages, chooseFiles, missing: saving.missing });
  const pageFiles = createPageFiles({ store, engine, reading, messages, fileOpening, opening, projects, database, absentPhotos });
  /** @type {Promise<import('./database.js').Database> | null} */
  let opened = null;
  /** The trouble that was told, and its message. */
  let told = { why: '', message: 0 };
  /** Whether the person had what could not be read tried again. */
  let tried = false;
  let asked = false;

  window.addEventListener('pagehide', () => void saving.flush());
  window.document.addEventListener('visibilitychange', () => {
    if (window.document.visibilityState === 'hidden') void saving.flush();
    else void look();
  });
  // Only while there is something to lose: a page that asks is kept by no browser for the way back.
  effect(() => {
    if (saving.unsaved.value || store.arriving.value > 0) window.addEventListener('beforeunload', ask);
    else window.removeEventListener('beforeunload', ask);
  });

  return {
    ...opening, ...projects, status: saving.status, progress: saving.progress, flush: saving.flush, isSafe: saving.isSafe, files, pageFiles, absentPhotos,
    begin, drawn: drawnStates.note, saveBroken,
  };

  async function begin() {
    await opening.begin();
    await projects.refresh().catch(() => {});
    setTimeout(() => void database().then(async (base) => {
      await sweep(base, locks);
      await journal.tidy(async (id) => (await base.get('projects', id))?.stamp);
    }).catch(() => {}), SWEEP_AFTER);
  }

  /** @param {BeforeUnloadEvent} event */
  function ask(event) {
    event.preventDefault();
  }

  /** Whether what is saved is still there, when the person comes back, or somebody has closed the database. */
  async function look() {
    shelves.restore();
    await saving.check();
  }

  /** Gives the project that cannot be shown to the person as a file. */
  async function saveBroken() {
    const project = opening.broken.peek();
    if (!project) return;
    if (project.id === store.place.peek().id) return files.save();
    try {
      const { file, name, unclean } = await rescued(await database(), project.id);
      saveFile(file, name);
      messages.note(strings.projectSaved(unclean));
    } catch (error) {
      messages.alert(strings.projectNotSaved(/** @type {Error} */ (error).message));
    }
  }

  function database() {
    opened ??= connect();
    return opened;
  }

  async function connect() {
    try {
      return await openDatabase({ onClosed });
    } catch (cause) {
      opened = null;
      throw failure('no-storage', /** @type {Error} */ (cause).message);
    }
  }

  /** Closed for a newer page, or by the browser, which may have thrown all away: what is used next is opened again. */
  function onClosed() {
    opened = null;
    setTimeout(() => void look(), LOOK_AFTER);
  }

  /** @param {import('../place.js').Place} place */
  function onWritten({ id }) {
    last.saved(id);
    last.opened(id);
  }

  function onSaved() {
    pictures.later();
    const gone = saving.missing.peek();
    const why = gone.map(({ id }) => id).join();
    if (told.why !== why || tried) {
      messages.close(told.message);
      told = { why, message: why === '' ? 0 : tellUnreadable(gone, tried) };
    }
    tried = false;
    // The browser may ask the person, who then knows what for.
    if (asked || navigator.userActivation?.hasBeenActive === false) return;
    asked = true;
    void navigator.storage?.persist?.().catch(() => false);
  }

  /** Photos of a project that was opened are not in the database. @param {readonly { id: string, name: string }[]} photos */
  function tellMissing(photos) {
    const names = photos.map(({ name }) => name);
    absentPhotos.tell(strings.photosNotHere(names, store.tray.peek().length), without(photos));
  }

  /**
   * Photos that are on the page can be read no more, and so not be saved.
   * @param {readonly { id: string, name: string }[]} photos
   * @param {boolean} again whether they were tried again
   * @returns {number} the message
   */
  function tellUnreadable(photos, again) {
    const text = strings.photosUnreadable(photos.map(({ name }) => name));
    if (again) return messages.grave(text, choose, without(photos));
    return messages.grave(text, { label: strings.saveAgain, run: () => { tried = true; void saving.again(); } }, choose);
  }

  /** @param {readonly { id: string }[]} photos @returns {import('../messages.js').Way} */
  function without(photos) {
    const ids = photos.map(({ id }) => id);
    return { label: strings.goOnWithout, run: () => { records.forgo(ids); reading.removeAll(ids); void saving.check(); } };
  }

  /** @param {import('./saving.js').Status} why @param {Error & { code?: string }} error */
  function onTrouble(why, error) {
    if (error.code === 'conflict') {
      // Both versions are kept.
      void opening.goOnAsCopy().then(() => {
        store.change({ type: 'rename', name: strings.copyOf(store.project.peek().name || strings.untitled), silent: true });
      });
      messages.note(strings.conflict);
      return;
    }
    if (told.why === why) return;
    const message = messages.grave(strings.notSaved(why, error.message), { label: strings.saveToFile, run: () => void files.save() });
    told = { why, message };
  }
}
