// @ts-check
/**
 * Files of any kind that were dropped, pasted, chosen or sent by the system. Each project among them becomes a project of
 * its own, one after the other; the last by name stays on the page, and the others are told, with a way to open them.
 * Photos go where a frame waits for them in any of these projects, and what is left joins the one on the page, as it
 * does where no project came along.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings.js';
import { byName } from './album.js';
import { isNamedPng } from './keeping/page-files.js';
import { isProjectFile } from './keeping/project-file.js';
import { openPlans } from './plans.js';
import { isSubtitles } from './subtitles.js';

/** @typedef {{ id: string, name: string }} Opened */
/** @typedef {{ name: string, open: () => Promise<boolean> }} ProjectFile */

/**
 * @param {{
 *   store: import('./store.js').Store, keeping: Pick<import('./keeping/keeping.js').Keeping, 'files' | 'pageFiles' | 'absentPhotos' | 'current' | 'open'>,
 *   reading: Pick<import('./reading.js').Reading, 'addFiles'>, subtitling: Pick<import('./subtitling.js').Subtitling, 'open'>,
 *   messages: Pick<import('./messages.js').Messages, 'offer'>, ownLayouts: Pick<import('./own-layouts.js').OwnLayouts, 'open'>,
 *   ownStyles: Pick<import('./own-styles.js').OwnStyles, 'open'>, showProjects: () => void,
 * }} app `showProjects` opens the list of projects
 */
export function createDroppedFiles({ store, keeping, reading, subtitling, messages, ownLayouts, ownStyles, showProjects }) {
  /** Projects of one drop are not mixed with those of the next, and photos wait for those before them. @type {Promise<unknown>} */
  let before = Promise.resolve();

  /** How many times files are being taken in. */
  const taking = signal(0);

  return { take, openProjects, busy: computed(() => taking.value > 0) };

  /** @param {readonly File[]} files */
  async function take(files) {
    taking.value += 1;
    await takeIn(files).finally(() => { taking.value -= 1; });
  }

  /** @param {readonly File[]} files */
  async function takeIn(files) {
    const plans = files.filter(({ name }) => name.toLowerCase().endsWith('.json'));
    const projects = files.filter(isProjectFile);
    const subtitles = files.filter(isSubtitles);
    const pictures = files.filter((file) => ![plans, projects, subtitles].some((list) => list.includes(file)));
    void openPlans(plans, { ownLayouts, ownStyles });
    const turn = before.then(() => openAll(projects, pictures));
    before = turn.catch(() => {});
    const { photos, shown } = await turn;
    await add(photos, shown);
    // Their video may have come with them.
    await subtitling.open(subtitles);
  }

  /** Opens files that were chosen as projects. @param {readonly File[]} files */
  async function openProjects(files) {
    const projects = byName(files).map((file) => (
      { name: file.name, open: () => (isNamedPng(file) ? keeping.pageFiles.openChosen(file) : keeping.files.open(file)) }
    ));
    const turn = before.then(() => oneByOne(projects));
    before = turn.catch(() => {});
    tell(await turn);
  }

  /**
   * @param {readonly File[]} files of projects
   * @param {readonly File[]} pictures
   * @returns {Promise<{ photos: File[], shown?: Opened }>} photos that no frame waited for, and the project that came with them
   */
  async function openAll(files, pictures) {
    const pages = await keeping.pageFiles.allAmong(pictures);
    const projects = byName([
      ...files.map((file) => ({ name: file.name, open: () => keeping.files.open(file) })),
      ...pages.map((page) => ({ name: page.file.name, open: () => keeping.pageFiles.open(page) })),
    ]);
    const photos = pictures.filter((file) => !pages.some((page) => page.file === file));
    if (projects.length === 0) return { photos: await keeping.absentPhotos.fill(photos) };
    const stops = keeping.files.stops();
    const placed = /** @type {Set<File>} */ (new Set());
    const opened = await oneByOne(projects, async () => {
      const rest = await keeping.absentPhotos.fill(photos);
      for (const file of photos) if (!rest.includes(file)) placed.add(file);
    });
    const stopped = keeping.files.stops() > stops;
    tell(opened);
    return { photos: stopped ? [] : photos.filter((file) => !placed.has(file)), shown: opened.at(-1) };
  }

  /**
   * @param {readonly ProjectFile[]} projects
   * @param {() => Promise<void>} [each] when one is on the page
   * @returns {Promise<Opened[]>} those that could be opened
   */
  async function oneByOne(projects, each = async () => {}) {
    /** @type {Opened[]} */
    const opened = [];
    const stops = keeping.files.stops();
    for (const { open } of projects) {
      // Whoever stops one wants none of those that follow.
      if (keeping.files.stops() > stops) break;
      if (!await open()) continue;
      await each();
      opened.push({ id: keeping.current.peek(), name: store.project.peek().name || strings.untitled });
    }
    return opened;
  }

  /** @param {readonly File[]} photos @param {Opened} [shown] the project that they came with: whoever opened it may not expect them there */
  async function add(photos, shown) {
    const count = store.tray.peek().length;
    await reading.addFiles(photos);
    const added = store.tray.peek().length - count;
    if (shown && added > 0 && keeping.current.peek() === shown.id) messages.offer(strings.photosWithProject(added, shown.name));
  }

  /** @param {readonly Opened[]} opened */
  function tell(opened) {
    const others = opened.slice(0, -1);
    const shown = opened.at(-1);
    if (!shown || others.length === 0) return;
    const [{ id, name }] = others;
    const way = others.length === 1 ? { label: strings.openNamed(name), run: () => void keeping.open(id) } : { label: strings.projects, run: showProjects };
    messages.offer(strings.projectsOpened(others.map((other) => other.name), shown.name), way);
  }
}
