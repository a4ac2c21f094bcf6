// @ts-check
/**
 * Pages that carry their project, out and in again. One that comes in becomes a project of its own, beside those that
 * there are; its photos are looked for on this device, then in the file, and what is missing keeps its place.
 */

import { signal } from '@preact/signals';
import { strings } from '../../strings.js';
import { EMPTY_PROJECT } from '../project.js';
import { foundPhotos } from './found-photos.js';
import { pageFileOf, readPageFile, withProject } from './page-file.js';
import { pageJson } from './page-json.js';
import { renamed } from './project-json.js';

/** @typedef {import('./project-json.js').FileProject} FileProject */
/** @typedef {import('./restoring.js').Content} Content */
/** @typedef {import('../album.js').Fact} Fact */
/** What a PNG carries: nothing, the project, or the photos too. @typedef {'none' | 'project' | 'photos'} Cargo */
/** @typedef {ReturnType<typeof createPageFiles>} PageFiles */

/** @param {File} file @returns {boolean} whether it says that it is a PNG */
export const isNamedPng = ({ name, type }) => type === 'image/png' || /\.png$/i.test(name);

/**
 * @param {{
 *   store: import('../store.js').Store, engine: Pick<import('../../engine/engine.js').Engine, 'photos'>,
 *   reading: Pick<import('../reading.js').Reading, 'addFiles' | 'resume'>, messages: import('../messages.js').Messages,
 *   fileOpening: import('./file-opening.js').FileOpening, opening: import('./opening.js').Opening,
 *   projects: import('./projects.js').Projects, database: () => Promise<import('./database.js').Database>,
 *   absentPhotos: Pick<import('./absent-photos.js').AbsentPhotos, 'tell'>,
 * }} app
 */
export function createPageFiles({ store, engine, reading, messages, fileOpening, opening, projects, database, absentPhotos }) {
  /** What the next PNG carries. @type {import('@preact/signals').Signal<Cargo>} */
  const cargo = signal('project');

  return { cargo, take, carrying, among, allAmong, open, openChosen };

  /** What this PNG carries. Photos go with the one for which they were asked, no other. @returns {Cargo} */
  function take() {
    const now = cargo.peek();
    if (now === 'photos') cargo.value = 'project';
    return now;
  }

  /**
   * @param {Blob} png
   * @param {import('../project.js').PageDocument} page that it shows
   * @param {Cargo} [what]
   * @returns {Promise<{ png: Blob, unclean: number }>} `unclean`: photos in it that keep what their files say
   */
  async function carrying(png, page, what = take()) {
    if (what === 'none') return { png, unclean: 0 };
    const fileOf = (/** @type {string} */ id) => (engine.photos.has(id) ? engine.photos.get(id).file : null);
    const { json, files, unclean } = await pageJson(store.project.peek(), page, { album: store.album.peek(), fileOf });
    const photos = what === 'photos' ? files : [];
    return { png: await withProject(png, json, photos), unclean: what === 'photos' ? unclean : 0 };
  }

  /** @param {readonly File[]} files @returns {Promise<import('./page-file.js').PageFile | null>} the first that carries a project */
  async function among(files) {
    return (await allAmong(files))[0] ?? null;
  }

  /** @param {readonly File[]} files @returns {Promise<import('./page-file.js').PageFile[]>} those that carry a project */
  async function allAmong(files) {
    const found = [];
    for (const file of files) {
      const page = isNamedPng(file) ? await pageFileOf(file).catch(() => null) : null;
      if (page) found.push(page);
    }
    return found;
  }

  /**
   * @param {import('./page-file.js').PageFile} page
   * @returns {Promise<boolean>} whether it is on the page now
   */
  async function open(page) {
    const { file } = page;
    /** What was there when its turn came, if anything. @type {{ id: string, name: string }[]} */
    const there = [];
    let missing = 0;
    const unread = /** @type {Content['unread']} */ ([]);
    const asPhoto = (/** @type {() => Promise<unknown>} */ first) => (
      { label: strings.useAsPhoto, run: () => void first().then(() => reading.addFiles([file])) }
    );
    const done = await fileOpening.open(file, async (hands) => {
      if (store.tray.peek().length > 0) there.push({ id: opening.current.peek(), name: store.project.peek().name || strings.untitled });
      const { project, archive } = await readPageFile(page, hands.planner);
      const content = await contentOf(onePage(project), archive, hands);
      missing = [...content.album.values()].filter(({ absent }) => absent).length;
      unread.push(...content.unread);
      return content;
    }, asPhoto(async () => {}));
    if (!done) return false;
    const before = there[0] ?? null;
    const way = asPhoto(() => leave(before?.id ?? null));
    const of = store.tray.peek().length;
    if (missing > 0) absentPhotos.tell(strings.photosMissing(file.name, missing, of), way);
    else messages.note(strings.pageOpened(file.name), before ? { label: strings.backTo(before.name), run: () => void opening.open(before.id) } : way, before ? way : undefined);
    await reading.resume(unread);
    return true;
  }

  /** Opens a PNG that was chosen as a project. @param {File} file @returns {Promise<boolean>} whether it is on the page now */
  async function openChosen(file) {
    const page = await among([file]);
    if (page) return open(page);
    const way = { label: strings.useAsPhoto, run: () => void reading.addFiles([file]) };
    messages.fileFailed(file.name, strings.noProjectInside, { text: strings.projectFileNotOpened(file.name, strings.noProjectInside), way });
    return false;
  }

  /** Back to what was there before, as if the page had not been opened. @param {string | null} id */
  async function leave(id) {
    const opened = opening.current.peek();
    if (id === opened) return;
    const back = id === null ? await opening.create() : await opening.open(id);
    if (back) await projects.remove(opened);
  }

  /**
   * @param {FileProject} project
   * @param {import('./file-opening.js').Archive} archive
   * @param {import('./file-opening.js').Hands} hands
   * @returns {Promise<Content>}
   */
  async function contentOf({ history, photos, dropped }, archive, hands) {
    const found = await foundPhotos(photos, { album: store.album.peek(), photos: engine.photos, database });
    const packed = photos.filter(({ id, path }) => archive.has(path) && !found.get(id)?.exact);
    const read = new Map((await hands.photos(packed, archive)).map((fact) => [fact.id, fact]));
    const album = /** @type {Map<string, Fact>} */ (new Map());
    const names = new Map();
    const [records, unread] = [/** @type {Content['records']} */ ([]), /** @type {Content['unread']} */ ([])];
    let number = 0;
    for (const photo of photos) {
      const other = read.has(photo.id) ? undefined : found.get(photo.id);
      const fact = other?.fact ?? read.get(photo.id) ?? await hands.absent(photo, (number += 1));
      album.set(fact.id, fact);
      names.set(photo.id, fact.id);
      if (!other?.record) continue;
      const { file, work, small } = other.record;
      if (work && small) records.push(other.record);
      else if (file) unread.push({ id: fact.id, file: file instanceof File ? file : new File([file], fact.name, { type: file.type }) });
    }
    return { history: { ...renamed(history, names), gesture: null }, album, videos: new Map(), records, unread, dropped };
  }
}

/** @param {FileProject} project @returns {FileProject} with the photos of its page only, and as a page that was shown */
function onePage({ history, photos, dropped }) {
  const page = /** @type {import('../project.js').PageDocument} */ (history.present.page);
  const shown = new Set(page.panels.map(({ photo }) => photo));
  const own = photos.filter(({ id }) => shown.delete(id));
  const known = new Set(own.map(({ id }) => id));
  const tray = own.map(({ id }) => history.present.tray.find((item) => item.id === id) ?? { id, use: true });
  const panels = page.panels.map((panel) => (known.has(panel.photo ?? '') ? panel : { ...panel, photo: null }));
  const whole = { ...page, panels, order: page.order.filter((id) => known.has(id)) };
  // Of a project that is more than its page, only what a page is made with.
  const { name, alike, order, locks, panels: wanted, styling } = history.present;
  const present = { ...EMPTY_PROJECT, name, alike, order, locks, panels: wanted, styling, tray, page: whole, pageId: 1, settings: page.page };
  return { photos: own, videos: [], dropped, history: { past: [], present, future: [], shown: [{ id: 1, page: whole }] } };
}
