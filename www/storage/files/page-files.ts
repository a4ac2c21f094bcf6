/**
 * Pages that carry their project, out and in again. One that comes in becomes a project of its own, beside those that
 * there are; its photos are looked for on this device, then in the file, and what is missing keeps its place.
 */

import { signal } from '@preact/signals';
import { strings } from '../../strings/strings.ts';
import { EMPTY_PROJECT } from '../../document/empty.ts';
import { foundPhotos } from './found-photos.ts';
import { pageFileOf, readPageFile, withProject } from './page-file.ts';
import { pageJson } from './page-json.ts';
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
import type { Archive, FileOpening, Hands } from './file-opening.ts';
import type { PageFile } from './page-file.ts';
import type { FileProject } from './project-json.ts';
import type { Signal } from '@preact/signals';

/** What a PNG carries: nothing, the project, or the photos too. */
export type Cargo = 'none' | 'project' | 'photos';
export type PageFiles = ReturnType<typeof createPageFiles>;

/** @returns whether it says that it is a PNG */
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
  engine: Pick<Engine, 'photos'>;
  reading: Pick<Reading, 'addFiles' | 'resume'>;
  messages: Messages;
  fileOpening: FileOpening;
  opening: Opening;
  projects: Projects;
  database: () => Promise<Database>;
  absentPhotos: Pick<AbsentPhotos, 'tell'>;
}) {
  /** What the next PNG carries. */
  const cargo: Signal<Cargo> = signal('project');

  return { cargo, take, carrying, among, allAmong, open, openChosen };

  /** What this PNG carries. Photos go with the one for which they were asked, no other. */
  function take(): Cargo {
    const now = cargo.peek();
    if (now === 'photos') cargo.value = 'project';
    return now;
  }

  /**
   * @param page that it shows
   * @returns `unclean`: photos in it that keep what their files say
   */
  async function carrying(
    png: Blob,
    page: PageDocument,
    what: Cargo = take(),
  ): Promise<{ png: Blob; unclean: number }> {
    if (what === 'none') return { png, unclean: 0 };
    const fileOf = (id: string) => (engine.photos.has(id) ? engine.photos.get(id).file : null);
    const { json, files, unclean } = await pageJson(store.project.peek(), page, { album: store.album.peek(), fileOf });
    const photos = what === 'photos' ? files : [];
    return { png: await withProject(png, json, photos), unclean: what === 'photos' ? unclean : 0 };
  }

  /** @returns the first that carries a project */
  async function among(files: readonly File[]): Promise<PageFile | null> {
    return (await allAmong(files))[0] ?? null;
  }

  /** @returns those that carry a project */
  async function allAmong(files: readonly File[]): Promise<PageFile[]> {
    const found = [];
    for (const file of files) {
      const page = isNamedPng(file) ? await pageFileOf(file).catch(() => null) : null;
      if (page) found.push(page);
    }
    return found;
  }

  /** @returns whether it is on the page now */
  async function open(page: PageFile): Promise<boolean> {
    const { file } = page;
    /** What was there when its turn came, if anything. */
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
        const { project, archive } = await readPageFile(page, hands.planner);
        const content = await contentOf(onePage(project), archive, hands);
        missing = [...content.album.values()].filter(({ absent }) => absent).length;
        unread.push(...content.unread);
        return content;
      },
      asPhoto(async () => {}),
    );
    if (!done) return false;
    const before = there[0] ?? null;
    const way = asPhoto(() => leave(before?.id ?? null));
    const of = store.tray.peek().length;
    if (missing > 0) absentPhotos.tell(strings.photosMissing(file.name, missing, of), way);
    else
      messages.note(
        strings.pageOpened(file.name),
        before ? { label: strings.backTo(before.name), run: () => void opening.open(before.id) } : way,
        before ? way : undefined,
      );
    await reading.resume(unread);
    return true;
  }

  /**
   * Opens a PNG that was chosen as a project.
   * @returns whether it is on the page now
   */
  async function openChosen(file: File): Promise<boolean> {
    const page = await among([file]);
    if (page) return open(page);
    const way = { label: strings.useAsPhoto, run: () => void reading.addFiles([file]) };
    messages.fileFailed(file.name, strings.noProjectInside, {
      text: strings.projectFileNotOpened(file.name, strings.noProjectInside),
      way,
    });
    return false;
  }

  /** Back to what was there before, as if the page had not been opened. */
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

/** @returns with the photos of its page only, and as a page that was shown */
function onePage({ history, photos, dropped }: FileProject): FileProject {
  const page = history.present.page as PageDocument;
  const shown = new Set(page.panels.map(({ photo }) => photo));
  const own = photos.filter(({ id }) => shown.delete(id));
  const known = new Set(own.map(({ id }) => id));
  const tray = own.map(({ id }) => history.present.tray.find((item) => item.id === id) ?? { id, use: true });
  const panels = page.panels.map((panel) => (known.has(panel.photo ?? '') ? panel : { ...panel, photo: null }));
  const whole = { ...page, panels, order: page.order.filter((id) => known.has(id)) };
  // Of a project that is more than its page, only what a page is made with.
  const { name, alike, order, locks, panels: wanted, styling } = history.present;
  const present = {
    ...EMPTY_PROJECT,
    name,
    alike,
    order,
    locks,
    panels: wanted,
    styling,
    tray,
    page: whole,
    pageId: 1,
    settings: page.page,
  };
  return {
    photos: own,
    videos: [],
    dropped,
    history: { past: [], present, future: [], shown: [{ id: 1, page: whole }] },
  };
}
