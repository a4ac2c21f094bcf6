/**
 * Handles files of any kind that are dropped, pasted, chosen or sent by the system. Each project among them is imported
 * separately, one after the other. The last one by name stays open, and a message lists the others with a way to open
 * them. Photos go to the frames in these projects that miss them. The other photos join the open project, also without
 * a project among the files. Sidecar files of systems and programs are skipped. A text that comes with photos is only
 * offered as a script.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { byName } from '../ui/by-name.ts';
import { isArchiveFile } from '../storage/files/page-archive.ts';
import { foldersOf } from '../photos/folders.ts';
import { hasRole, isSidecar, kindByContent, kindByName } from '../engine/file-kinds.ts';
import { nextTask } from '../engine/scheduler.ts';
import { splitLivePhotos } from '../photos/live-photos.ts';
import { isNamedPng } from '../storage/files/page-files.ts';
import { isProjectFile } from '../storage/files/project-file.ts';
import { importing } from '../ui/importing.ts';
import { openPlans } from './plans.ts';
import { momentsOf } from '../lettering/cue-times.ts';
import { speechAmong } from '../lettering/subtitling.ts';
import type { Store } from '../document/store.ts';
import type { OwnLayouts } from '../layouts/own-layouts.ts';
import type { Subtitling } from '../lettering/subtitling.ts';
import type { Reading } from '../photos/reading.ts';
import type { Moments } from '../lettering/cue-times.ts';
import type { Keeping } from '../storage/storage.ts';
import type { PageFile } from '../storage/files/page-file.ts';
import type { OwnPainters } from '../painters/own-painters.ts';
import type { OwnStyles } from '../styles/own-styles.ts';
import type { Messages } from '../ui/messages.ts';

/** Names of files in the message about a whole drop that failed. */
const NAMED = 3;

/** Subtitles, and texts, which may be scripts. */
const isSpeech = ({ name }: File) => hasRole(name, 'subtitles', 'text');
const isText = ({ name }: File) => hasRole(name, 'text');

const namesOf = (files: readonly File[]) =>
  files
    .slice(0, NAMED)
    .map(({ name }) => name)
    .join(', ');

type Opened = { id: string; name: string };
type ProjectFile = { name: string; open: () => Promise<boolean> };

/** @param app `showProjects` opens the list of projects */
export function createDroppedFiles({
  store,
  keeping,
  reading,
  subtitling,
  messages,
  ownLayouts,
  ownStyles,
  ownPainters,
  showProjects,
}: {
  store: Store;
  keeping: Pick<Keeping, 'files' | 'pageFiles' | 'absentPhotos' | 'current' | 'open' | 'turned'>;
  reading: Pick<Reading, 'addFiles'>;
  subtitling: Pick<Subtitling, 'open'>;
  messages: Pick<Messages, 'note' | 'offer' | 'fileFailed' | 'filesSkipped'>;
  ownLayouts: Pick<OwnLayouts, 'open'>;
  ownStyles: Pick<OwnStyles, 'open'>;
  ownPainters: Pick<OwnPainters, 'open'>;
  showProjects: () => void;
}) {
  /** Projects of one drop are not mixed with projects of the next one, and photos wait for earlier photos. */
  let before: Promise<unknown> = Promise.resolve();

  /** How many times files are being taken in. */
  const taking = signal(0);

  return { take, openProjects, busy: computed(() => taking.value > 0) };

  async function take(files: readonly File[]) {
    if (files.length === 0) return;
    taking.value += 1;
    await importing(messages, namesOf(files), () => takeIn(files));
    taking.value -= 1;
  }

  async function takeIn(given: readonly File[]) {
    const wanted = given.filter((file) => !isSidecar(file.name, foldersOf(file)));
    // A single sidecar file is reported like any other file that is not a photo.
    const files = wanted.length > 0 ? wanted : given;
    if (files.length < given.length) messages.filesSkipped(given.length - files.length);
    const plans = files.filter(({ name }) => hasRole(name, 'json'));
    const projects = files.filter(isProjectFile);
    const packed = await zipped(files);
    const archives = files.filter((file) => !projects.includes(file) && (isArchiveFile(file) || packed.includes(file)));
    const boards = files.filter(({ name }) => hasRole(name, 'board'));
    const models = files.filter(({ name }) => hasRole(name, 'painters'));
    const pictures = files.filter(
      (file) => ![plans, projects, archives, boards, models].some((list) => list.includes(file)),
    );
    for (const { name } of boards) messages.fileFailed(name, strings.boardFile);
    const beside = projects.length + archives.length > 0 || pictures.some((file) => !isSpeech(file));
    const speech = speechAmong(files);
    void ownPainters.open(models);
    void openPlans(plans, { ownLayouts, ownStyles, messages, beside });
    // Files that are dropped while another project opens belong to that project.
    const turn = Promise.all([speech, before, keeping.turned()]).then(([spoken]) =>
      openAll(
        projects,
        pictures.filter((file) => !spoken.includes(file) && !(beside && isText(file) && foldersOf(file).length > 0)),
        archives,
      ),
    );
    before = turn.catch(() => {});
    const { photos, shown } = await turn;
    await add(photos, shown, await momentsOf(photos, await speech));
    const spoken = await speech;
    const scripts = beside ? spoken.filter(isText) : [];
    // Their video may have come with them.
    await subtitling.open(spoken.filter((file) => !scripts.includes(file)));
    if (scripts.length > 0)
      messages.offer(strings.scriptOffered({ names: strings.listed(scripts.map(({ name }) => name)) }), {
        label: strings.putScript,
        run: () => void subtitling.open(scripts),
      });
  }

  /** @returns archives with the name of another kind: many `.cbr` files are ZIP files */
  async function zipped(files: readonly File[]): Promise<File[]> {
    const named = files.filter(({ name }) => kindByName(name)?.remedy === 'unpack');
    const kinds = await Promise.all(named.map((file) => kindByContent(file).catch(() => undefined)));
    return named.filter((_, i) => kinds[i]?.role === 'archive');
  }

  /** Opens files that were chosen as projects. */
  async function openProjects(files: readonly File[]) {
    const projects = byName(files).map((file) => ({
      name: file.name,
      open: () =>
        isNamedPng(file) || (isArchiveFile(file) && !isProjectFile(file))
          ? keeping.pageFiles.openChosen(file, keeping.files.open)
          : keeping.files.open(file),
    }));
    const turn = Promise.all([before, keeping.turned()]).then(() => oneByOne(projects));
    before = turn.catch(() => {});
    await importing(messages, namesOf(files), async () => tell(await turn));
  }

  /**
   * @param files of projects
   * @param archives of pages, or of pictures, which join the others
   * @returns photos that no frame waited for, and the project that came with them
   */
  async function openAll(
    projectFiles: readonly File[],
    loose: readonly File[],
    archives: readonly File[],
  ): Promise<{ photos: File[]; shown?: Opened }> {
    const inside = [];
    for (const archive of byName(archives)) inside.push(await keeping.pageFiles.unpacked(archive));
    const files = [...projectFiles, ...inside.flatMap(({ project }) => project ?? [])];
    const pictures = [...loose, ...inside.flatMap((archive) => archive.pictures)];
    const found = await keeping.pageFiles.allAmong(pictures);
    // Other files of the drop may contain the photos of the pages.
    const alone = files.length + inside.length === 0 && pictures.length === found.length;
    const lost = alone ? await withoutPhotos(found) : [];
    const pages = [...inside.flatMap(({ page }) => page ?? []), ...found.filter((page) => !lost.includes(page))];
    const projects = byName([
      ...files.map((file) => ({ name: file.name, open: () => keeping.files.open(file) })),
      ...pages.map((page) => ({ name: page.file.name, open: () => keeping.pageFiles.open(page) })),
    ]);
    const photos = pictures.filter((file) => !pages.some((page) => page.file === file));
    if (projects.length === 0) return { photos: await keeping.absentPhotos.fill(photos) };
    const stops = keeping.files.stops();
    const placed = new Set() as Set<File>;
    const opened = await oneByOne(projects, async () => {
      const rest = await keeping.absentPhotos.fill(photos);
      for (const file of photos) if (!rest.includes(file)) placed.add(file);
    });
    const stopped = keeping.files.stops() > stops;
    tell(opened);
    return { photos: stopped ? [] : photos.filter((file) => !placed.has(file)), shown: opened.at(-1) };
  }

  /** Finds PNG files of pages whose photos are missing: they were shared as pictures. */
  async function withoutPhotos(found: readonly PageFile[]): Promise<PageFile[]> {
    const lost: PageFile[] = [];
    for (const page of found) if (await keeping.pageFiles.lacksPhotos(page)) lost.push(page);
    if (lost.length === 1) {
      const [page] = lost;
      messages.note(strings.openedAsPicture({ name: page.file.name }), {
        label: strings.openAsProject,
        run: () => void keeping.pageFiles.open(page),
      });
    }
    return lost;
  }

  /**
   * @param each when one is on the page
   * @returns the projects that could be opened
   */
  async function oneByOne(
    projects: readonly ProjectFile[],
    each: () => Promise<void> = async () => {},
  ): Promise<Opened[]> {
    const opened: Opened[] = [];
    const stops = keeping.files.stops();
    for (const { open } of projects) {
      // If the user stops one, the following ones are not opened.
      if (keeping.files.stops() > stops) break;
      if (!(await open())) continue;
      await each();
      opened.push({ id: keeping.current.peek(), name: store.project.peek().name || strings.untitled });
    }
    return opened;
  }

  /** @param shown the project that they came with; the user who opened it may not expect them there */
  async function add(photos: readonly File[], shown: Opened | undefined, moments: Moments) {
    const count = store.tray.peek().length;
    const { videos, others } = splitLivePhotos(photos);
    // The board appears with them, which is as much work again as to look through hundreds of files.
    await nextTask();
    await reading.addFiles(others, undefined, moments);
    if (videos.length > 0)
      messages.offer(strings.liveVideos({ n: videos.length }), {
        label: strings.addLiveVideos({ n: videos.length }),
        run: () => void reading.addFiles(videos),
      });
    const added = store.tray.peek().length - count;
    if (shown && added > 0 && keeping.current.peek() === shown.id)
      messages.offer(strings.photosWithProject({ n: added, name: shown.name }));
  }

  function tell(opened: readonly Opened[]) {
    const others = opened.slice(0, -1);
    const shown = opened.at(-1);
    if (!shown || others.length === 0) return;
    const [{ id, name }] = others;
    const way =
      others.length === 1
        ? { label: strings.openNamed({ name }), run: () => void keeping.open(id) }
        : { label: strings.projects, run: showProjects };
    const { two, more } = strings.projectsOpened;
    const told =
      others.length === 1
        ? two({ other: name, shown: shown.name })
        : more({ all: opened.length, more: others.length, shown: shown.name });
    messages.offer(told, way);
  }
}
