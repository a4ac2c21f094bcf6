/**
 * Storage: connects the parts that save the user's work.
 *
 * - `database.ts` the tables; `versions.ts` checks and migrates data from the database or from files
 * - `snapshot.ts` selects the data to save; `photo-records.ts` writes photos; `saving.ts` schedules writes;
 *   `journal.ts` stores the last edits
 * - `state-records.ts` reads the document in a record, also of earlier versions
 * - `restoring.ts` reads a project; `rehearsing.ts` tries it before it is shown
 * - `opening.ts` manages the open project; `last-project.ts` selects the first one; `projects.ts` is the project list
 * - `rescue.ts` exports a project that cannot be opened
 * - `drawn-states.ts` the last states that were drawn, as a fallback
 * - `pictures.ts` thumbnails; `sweeping.ts` deletes data that no project needs, after a day (`orphans.ts`)
 * - `locks.ts` locks between tabs; `shelves.ts` lists that all projects share
 * - `archive.ts` ZIP files; `project-file.ts` a project as a ZIP file; `file-opening.ts` opens a file of any kind
 * - `page-files.ts` PNGs with their project: `page-json.ts` is the text, `page-file.ts` the PNG chunks
 * - `identity.ts` identifies photos; `found-photos.ts` and `absent-photos.ts` find missing ones
 *
 * The document is plain data and is saved completely: new fields need no changes here.
 */

import { effect } from '@preact/signals';
import { failure } from '../engine/protocol.ts';
import { textAt } from '../strings/compose.ts';
import { strings } from '../strings/strings.ts';
import { save as saveFile } from '../ui/files.ts';
import { createAbsentPhotos } from './files/absent-photos.ts';
import { openDatabase } from './database.ts';
import { createDrawnStates } from './drawn-states.ts';
import { createFileOpening } from './files/file-opening.ts';
import { createJournal } from './journal.ts';
import { createLastProject } from './last-project.ts';
import { after } from '../engine/scheduler.ts';
import { createLocks } from './locks.ts';
import { createOpening } from './opening.ts';
import { createPageFiles } from './files/page-files.ts';
import { createPhotoRecords } from './photo-records.ts';
import { createPictures } from './pictures.ts';
import { createProjectFiles } from './files/project-file.ts';
import { createProjects } from './projects.ts';
import { rescued } from './rescue.ts';
import { createSaving } from './saving.ts';
import { sweep } from './sweeping.ts';
import { explain } from '../ui/explain.ts';
import type { Messages, Way } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Engine } from '../engine/engine.ts';
import type { Reading } from '../photos/reading.ts';
import type { Database } from './database.ts';
import type { Views } from './opening.ts';
import type { Place } from '../document/place.ts';
import type { Status } from './saving.ts';
import type { Shelves } from './shelves.ts';

export type Keeping = ReturnType<typeof createKeeping>;

/** Milliseconds after the start until unused data is deleted. */
const SWEEP_AFTER = 8_000;
/** Delay in milliseconds until a closed database is checked, so that the other tab comes first. */
const LOOK_AFTER = 300;

/** @param app `chooseFiles` opens the browser's file dialog */
export function createKeeping({
  store,
  reading,
  engine,
  scheduler,
  shelves,
  messages,
  window,
  leave,
  chooseFiles = () => {},
  views,
}: {
  store: Store;
  reading: Reading;
  engine: Engine;
  scheduler: Scheduler;
  shelves: Shelves;
  messages: Messages;
  window: Window;
  leave: () => void;
  chooseFiles?: () => void;
  views?: Views;
}) {
  const { navigator } = window;
  const locks = createLocks(navigator.locks);
  const last = createLastProject({ tab: () => window.sessionStorage, browser: () => window.localStorage });
  const records = createPhotoRecords({ photos: engine.photos, originals: store.originals });
  const onDrawn = () => void projects.refresh().catch(() => {});
  const pictures = createPictures({ store, engine, scheduler, database, onDrawn });
  const drawnStates = createDrawnStates({ store });
  const journal = createJournal({ box: () => window.localStorage });
  const saving = createSaving({
    store,
    records,
    journal,
    locks,
    database,
    drawnStates,
    scheduler,
    onTrouble,
    onWritten,
    onSaved,
  });
  const opening = createOpening({
    store,
    reading,
    engine,
    shelves,
    saving,
    records,
    locks,
    messages,
    database,
    journal,
    last,
    drawnStates,
    leave,
    views,
    onMissing: (photos) => tellMissing(photos),
    onUnwritten: (names) =>
      void (
        names.length > 0 &&
        messages.grave(strings.photosNeverSaved({ names: strings.someNames(names), n: names.length }), choose)
      ),
  });
  const projects = createProjects({ store, opening, saving, locks, messages, database });
  const fileOpening = createFileOpening({ engine, messages, opening });
  const files = {
    ...createProjectFiles({ store, engine, messages, saving, fileOpening, box: () => window.localStorage }),
    progress: fileOpening.progress,
    cancel: fileOpening.cancel,
    stops: fileOpening.stops,
  };
  const choose = { label: strings.choosePhotos, run: chooseFiles };
  const absentPhotos = createAbsentPhotos({ store, engine, reading, messages, chooseFiles, missing: saving.missing });
  const pageFiles = createPageFiles({
    store,
    engine,
    reading,
    messages,
    fileOpening,
    opening,
    projects,
    database,
    absentPhotos,
  });
  let opened: Promise<Database> | null = null;
  /** The current problem and its message. */
  let told = { why: '', message: 0 };
  /** Whether the user retried unreadable photos. */
  let tried = false;
  let asked = false;

  window.addEventListener('pagehide', () => void saving.flush());
  window.document.addEventListener('visibilitychange', () => {
    if (window.document.visibilityState === 'hidden') void saving.flush();
    else void look();
  });
  // Only with unsaved data, because browsers do not cache pages with this listener.
  effect(() => {
    if (saving.unsaved.value || store.arriving.value > 0) window.addEventListener('beforeunload', ask);
    else window.removeEventListener('beforeunload', ask);
  });

  return {
    ...opening,
    ...projects,
    status: saving.status,
    progress: saving.progress,
    flush: saving.flush,
    isSafe: saving.isSafe,
    files,
    pageFiles,
    absentPhotos,
    begin,
    drawn: drawnStates.note,
    saveBroken,
  };

  async function begin() {
    await opening.begin();
    await projects.refresh().catch(() => {});
    scheduler.background(() => tidy().catch(() => {}), { delay: SWEEP_AFTER });
  }

  /** Deletes unused data. */
  async function tidy() {
    const base = await database();
    await sweep(base, locks);
    await journal.tidy(async (id) => (await base.get('projects', id))?.stamp);
  }

  function ask(event: BeforeUnloadEvent) {
    event.preventDefault();
  }

  /** Checks that saved data still exists, when the user returns or after the database was closed. */
  async function look() {
    shelves.restore();
    await saving.check();
  }

  /** Saves the project that cannot be opened as a file for the user. */
  async function saveBroken() {
    const project = opening.broken.peek();
    if (!project) return;
    if (project.id === store.place.peek().id) return files.save();
    try {
      const { file, name } = await rescued(await database(), project.id);
      saveFile(file, name);
      messages.note(strings.projectSaved.original);
    } catch (error) {
      messages.alert(strings.projectNotSaved({ why: explain(error) }));
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
      throw failure('no-storage', (cause as Error).message);
    }
  }

  /**
   * Handles a database that was closed by a newer app version or by the browser, which may have deleted it. The next
   * use opens it again.
   */
  function onClosed() {
    opened = null;
    after(LOOK_AFTER, () => void look());
  }

  function onWritten({ id }: Place) {
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
    // The browser may show a prompt, and the user must know the reason for it.
    if (asked || navigator.userActivation?.hasBeenActive === false) return;
    asked = true;
    void navigator.storage?.persist?.().catch(() => false);
  }

  /** Photos of a project that was opened are not in the database. */
  function tellMissing(photos: readonly { id: string; name: string }[]) {
    const [n, of] = [photos.length, store.tray.peek().length];
    const names = strings.someNames(photos.map(({ name }) => name));
    const { some, all } = strings.photosNotHere;
    absentPhotos.tell(n < of ? some({ names, n, of }) : all({ names, n }), without(photos));
  }

  /**
   * Photos that are on the page can be read no more, and so not be saved.
   * @param again whether they were tried again
   * @returns the message
   */
  function tellUnreadable(photos: readonly { id: string; name: string }[], again: boolean): number {
    const names = strings.someNames(photos.map(({ name }) => name));
    const text = strings.photosUnreadable({ names, n: photos.length });
    if (again) return messages.grave(text, choose, without(photos));
    return messages.grave(
      text,
      {
        label: strings.saveAgain,
        run: () => {
          tried = true;
          void saving.again();
        },
      },
      choose,
    );
  }

  function without(photos: readonly { id: string }[]): Way {
    const ids = photos.map(({ id }) => id);
    return {
      label: strings.goOnWithout,
      run: () => {
        records.forgo(ids);
        reading.removeAll(ids);
        void saving.check();
      },
    };
  }

  function onTrouble(why: Status, error: Error & { code?: string }) {
    if (error.code === 'conflict') {
      // Both versions are retained.
      void opening.goOnAsCopy().then(() => {
        store.change({
          type: 'rename',
          name: strings.nameOfCopy(store.project.peek().name || strings.untitled),
          silent: true,
        });
      });
      messages.note(strings.conflict);
      return;
    }
    if (told.why === why) return;
    const reason = textAt(strings.storageTrouble, why) ?? explain(error).replace(/\.$/, '');
    const message = messages.grave(strings.notSaved({ why: reason }), {
      label: strings.saveToFile,
      run: () => void files.save(),
    });
    told = { why, message };
  }
}
