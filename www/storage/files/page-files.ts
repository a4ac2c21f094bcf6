/**
 * Pages that carry their project, out and in again. An imported page becomes a separate project. Its photos are
 * searched on this device, then in the file. Missing photos keep their places.
 */

import { signal } from '@preact/signals';
import { strings } from '../../strings/strings.ts';
import { EMPTY_PROJECT } from '../../document/empty.ts';
import { MOST } from '../../document/limits.ts';
import { photosOn, sheetsOf } from '../../engine/sheets.ts';
import { foundPhotos } from './found-photos.ts';
import { reasonOfKind } from '../../ui/reason-of-kind.ts';
import { isArchiveFile, projectEntry, readInside } from './page-archive.ts';
import { pageFileOf, withProject } from './page-file.ts';
import { numbered, pageJson } from './page-json.ts';
import { renamed } from './project-json.ts';
import type { Messages } from '../../ui/messages.ts';
import type { Fact } from '../../document/album.ts';
import type { PageDocument } from '../../document/project.ts';
import type { Store } from '../../document/store.ts';
import type { Engine } from '../../engine/engine.ts';
import type { Reading } from '../../photos/reading.ts';
import type { Database } from '../database.ts';
import type { Opening } from '../opening.ts';
import type { Projects } from '../projects.ts';
import type { Content } from '../restoring.ts';
import type { AbsentPhotos } from './absent-photos.ts';
import type { Work } from '../../engine/archive.ts';
import type { Archive, FileOpening, Hands } from './file-opening.ts';
import type { PageFile } from './page-file.ts';
import type { FileProject } from './project-json.ts';
import type { Signal } from '@preact/signals';

/** Data in a PNG or an archive of pages: nothing, the project, or the project with its photos. */
export type Cargo = 'none' | 'project' | 'photos';
export type PageFiles = ReturnType<typeof createPageFiles>;

/** @returns whether name or type mark it as a PNG */
export const isNamedPng = ({ name, type }: File): boolean => type === 'image/png' || /\.png$/i.test(name);

export function createPageFiles({
  store,
  engine,
  reading,
  messages,
  fileOpening,
  opening,
  projects,
  database,
  absentPhotos,
}: {
  store: Store;
  engine: Pick<Engine, 'photos' | 'ready'>;
  reading: Pick<Reading, 'addFiles' | 'resume'>;
  messages: Messages;
  fileOpening: FileOpening;
  opening: Opening;
  projects: Projects;
  database: () => Promise<Database>;
  absentPhotos: Pick<AbsentPhotos, 'tell'>;
}) {
  /** Data in the next PNG or archive. A shared picture contains the project only if the user asks for it. */
  const cargo: Signal<Cargo> = signal('none');

  return { cargo, take, photoBytes, carrying, packed, among, allAmong, lacksPhotos, unpacked, open, openChosen };

  /** Returns the data for this file. The next file contains no project again. */
  function take(): Cargo {
    const now = cargo.peek();
    cargo.value = 'none';
    return now;
  }

  /** @returns the size of the photos that the next file contains; with their metadata, which is small */
  function photoBytes(): number {
    if (cargo.value !== 'photos') return 0;
    const shown = [...photosOn(store.sheets.value)];
    return shown.reduce((sum, id) => sum + (engine.photos.has(id) ? engine.photos.get(id).file.size : 0), 0);
  }

  /**
   * @param page that it shows
   * @returns `unclean`: number of photos with metadata
   */
  async function carrying(
    png: Blob,
    page: PageDocument,
    what: Cargo = take(),
    work: Work = {},
  ): Promise<{ png: Blob; unclean: number }> {
    if (what === 'none') return { png, unclean: 0 };
    const { json, files, unclean } = await told(page, work);
    const photos = what === 'photos' ? files : [];
    return { png: await withProject(png, json, photos, work), unclean: what === 'photos' ? unclean : 0 };
  }

  /** @returns the additional file in an archive of pages; null without a project */
  async function packed(
    what: Cargo,
    work: Work = {},
  ): Promise<{ entry: { name: string; blob: Blob }; unclean: number } | null> {
    const page = store.page.peek();
    if (what === 'none' || !page) return null;
    const { json, files, unclean } = await told(page, work);
    const photos = what === 'photos';
    return { entry: await projectEntry(json, photos ? files : [], work), unclean: photos ? unclean : 0 };
  }

  function told(page: PageDocument, work: Work) {
    const fileOf = (id: string) => (engine.photos.has(id) ? engine.photos.get(id).file : null);
    return pageJson(store.project.peek(), page, { album: store.album.peek(), fileOf, ...work });
  }

  /**
   * Reads an archive that the user dropped or chose.
   * @returns its project, or the archive itself if it is a project file under another name; and its images. Errors are
   *   shown
   */
  async function unpacked(file: File): Promise<{ page?: PageFile; project?: File; pictures: File[] }> {
    const inside = await fileOpening.unpack(file, (watch, step) => readInside(file, { ...watch, step }));
    if (!inside) return { pictures: [] };
    if ('page' in inside) return { page: inside.page, pictures: [] };
    if ('project' in inside) return { project: file, pictures: [] };
    const { pictures, damaged, beyond, unsupported, others } = inside;
    for (const name of damaged) messages.fileFailed(name, strings.damagedInArchive({ archive: file.name }));
    if (beyond > 0) messages.alert(strings.tooManyPhotos({ n: beyond, most: strings.decimal(MOST.photos) }));
    for (const { name, kind } of unsupported) messages.fileFailed(name, reasonOfKind(kind));
    if (others > 0 && pictures.length > 0) messages.filesSkipped(others);
    if (pictures.length + damaged.length + unsupported.length === 0)
      messages.fileFailed(file.name, strings.noPicturesInside);
    return { pictures };
  }

  /** @returns the first that carries a project */
  async function among(files: readonly File[]): Promise<PageFile | null> {
    return (await allAmong(files))[0] ?? null;
  }

  /** @returns files with a project */
  async function allAmong(files: readonly File[]): Promise<PageFile[]> {
    const found = [];
    for (const file of files) {
      const page = isNamedPng(file) ? await pageFileOf(file).catch(() => null) : null;
      if (page) found.push(page);
    }
    return found;
  }

  /** Returns whether a PNG shows photos, and neither the file nor this device has any of them. */
  async function lacksPhotos({ file, read }: PageFile): Promise<boolean> {
    if (isArchiveFile(file)) return false;
    // A damaged project is reported when it is opened.
    const inside = await read(await engine.ready).catch(() => null);
    if (!inside) return false;
    const { photos } = pagesAlone(inside.project);
    if (photos.length === 0 || photos.some(({ path }) => inside.archive.has(path))) return false;
    return (await foundPhotos(photos, { album: store.album.peek(), photos: engine.photos, database })).size === 0;
  }

  /** @returns whether it is on the page now */
  async function open(page: PageFile): Promise<boolean> {
    const { file } = page;
    const picture = !isArchiveFile(file);
    /** The project that was open before its turn, if any. */
    const there: { id: string; name: string }[] = [];
    let missing = 0;
    const unread = [] as Content['unread'];
    const asPhoto = (first: () => Promise<unknown>) => ({
      label: strings.useAsPhoto,
      run: () => void first().then(() => reading.addFiles([file])),
    });
    const done = await fileOpening.open(
      file,
      async (hands) => {
        if (store.tray.peek().length > 0)
          there.push({ id: opening.current.peek(), name: store.project.peek().name || strings.untitled });
        const { project, archive } = await page.read(hands.planner, hands.watch);
        const content = await contentOf(pagesAlone(project), archive, hands);
        missing = [...content.album.values()].filter(({ absent }) => absent).length;
        unread.push(...content.unread);
        return content;
      },
      picture ? asPhoto(async () => {}) : undefined,
    );
    if (!done) return false;
    const before = there[0] ?? null;
    const way = picture ? asPhoto(() => leave(before?.id ?? null)) : undefined;
    const of = store.tray.peek().length;
    const { name } = file;
    if (missing > 0) {
      const { some, all } = strings.photosMissing;
      absentPhotos.tell(missing < of ? some({ name, n: missing, of }) : all({ name, n: missing }), way);
    } else
      messages.note(
        strings.pageOpened({ name: file.name }),
        before ? { label: strings.backTo({ name: before.name }), run: () => void opening.open(before.id) } : way,
        before ? way : undefined,
      );
    await reading.resume(unread);
    return true;
  }

  /**
   * Opens a PNG or an archive that was chosen as a project.
   * @param openProject opens a project file
   * @returns whether it is on the page now
   */
  async function openChosen(file: File, openProject: (file: File) => Promise<boolean>): Promise<boolean> {
    const { page, project, pictures } = isArchiveFile(file)
      ? await unpacked(file)
      : { page: await among([file]), project: undefined, pictures: [file] };
    if (page) return open(page);
    if (project) return openProject(project);
    if (pictures.length === 0) return false;
    const way = { label: strings.useAsPhoto, run: () => void reading.addFiles(pictures) };
    messages.fileFailed(file.name, strings.noProjectInside, {
      text: strings.projectFileNotOpened({ name: file.name, why: strings.noProjectInside }),
      way,
    });
    return false;
  }

  /** Restores the project that was open before the page. */
  async function leave(id: string | null) {
    const opened = opening.current.peek();
    if (id === opened) return;
    const back = id === null ? await opening.create() : await opening.open(id);
    if (back) await projects.remove(opened);
  }

  async function contentOf(
    { history, photos, dropped }: FileProject,
    archive: Archive,
    hands: Hands,
  ): Promise<Content> {
    const found = await foundPhotos(photos, { album: store.album.peek(), photos: engine.photos, database });
    const packed = photos.filter(({ id, path }) => archive.has(path) && !found.get(id)?.exact);
    const read = new Map((await hands.photos(packed, archive)).map((fact) => [fact.id, fact]));
    const album = new Map() as Map<string, Fact>;
    const names = new Map();
    const [records, unread] = [[] as Content['records'], [] as Content['unread']];
    let number = 0;
    for (const photo of photos) {
      const other = read.has(photo.id) ? undefined : found.get(photo.id);
      const fact = other?.fact ?? read.get(photo.id) ?? (await hands.absent(photo, (number += 1)));
      album.set(fact.id, fact);
      names.set(photo.id, fact.id);
      if (!other?.record) continue;
      const { file, work, small } = other.record;
      if (work && small) records.push(other.record);
      else if (file)
        unread.push({
          id: fact.id,
          file: file instanceof File ? file : new File([file], fact.name, { type: file.type }),
        });
    }
    return {
      history: renamed(history, names),
      album,
      videos: new Map(),
      records,
      unread,
      dropped,
    };
  }
}

/** @returns with the photos of its pages only, and each as a page that was shown */
function pagesAlone({ history, photos, dropped }: FileProject): FileProject {
  const pages = sheetsOf(history.present).map(({ page }) => page);
  const shown = photosOn(pages);
  const own = photos.filter(({ id }) => shown.delete(id));
  const known = new Set(own.map(({ id }) => id));
  const tray = own.map(({ id }) => history.present.tray.find((item) => item.id === id) ?? { id, use: true });
  const whole = pages.map((page) => ({
    ...page,
    panels: page.panels.map((panel) => (known.has(panel.photo ?? '') ? panel : { ...panel, photo: null })),
    order: page.order.filter((id) => known.has(id)),
  }));
  // Only the parts of the project that its pages need.
  const { name, alike, order, locks, panels: wanted, styling, at } = history.present;
  const sheets = numbered(whole, at);
  const present = {
    ...EMPTY_PROJECT,
    name,
    alike,
    order,
    locks,
    panels: wanted,
    styling,
    tray,
    ...sheets,
    settings: sheets.page.page,
  };
  return {
    photos: own,
    videos: [],
    dropped,
    history: {
      present,
      shown: whole.map((page, i) => ({ id: i + 1, page, ...(i > 0 ? { sheet: i } : {}) })),
    },
  };
}
