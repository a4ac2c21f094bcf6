/**
 * A project as one file: a ZIP archive of `project.json` and the files of its photos and videos, byte for byte. For files
 * that are passed on, the user can remove metadata; pixels stay the same.
 */

import { signal } from '@preact/signals';
import { PLACES_FOR_LOST, TEXT } from '../../engine/limits.ts';
import { strings } from '../../strings/strings.ts';
import { createEditing } from '../../document/editing.ts';
import { sheetsOf } from '../../engine/sheets.ts';
import { fileNameOf } from '../../ui/file-name.ts';
import { save as saveFile } from '../../ui/files.ts';
import { rememberedSwitch } from '../../ui/remembered.ts';
import { archiveOf, readArchive } from '../../engine/archive.ts';
import { strippedOf } from '../../photos/identity.ts';
import { projectJson, readProjectJson } from './project-json.ts';
import { factsOf, photosOf } from '../snapshot.ts';
import { damaged } from '../../engine/protocol.ts';
import { explain } from '../../ui/explain.ts';
import type { Messages } from '../../ui/messages.ts';
import type { Fact, Video } from '../../document/album.ts';
import type { Beginning } from '../../document/history.ts';
import type { Planner, Store } from '../../document/store.ts';
import type { Engine } from '../../engine/engine.ts';
import type { Saving } from '../saving.ts';
import type { Work } from '../../engine/archive.ts';
import type { Archive, FileOpening, Hands } from './file-opening.ts';
import type { FilePhoto, FileProject } from './project-json.ts';
import type { Signal } from '@preact/signals';

export const EXTENSION = '.inkpanel';
const CLEAN_KEY = 'inkpanel.clean';

/** @param unclean names of photos that still have metadata; null if no metadata was removed */
function savedWith(unclean: readonly string[] | null): string {
  const { original, clean, unclean: partly } = strings.projectSaved;
  if (unclean === null) return original;
  return unclean.length === 0 ? clean : partly({ names: strings.someNames(unclean), n: unclean.length });
}

export function isProjectFile({ name }: { name: string }) {
  return name.toLowerCase().endsWith(EXTENSION);
}

export function createProjectFiles({
  store,
  engine,
  messages,
  saving: saves,
  fileOpening,
  box,
}: {
  store: Store;
  engine: Pick<Engine, 'photos'>;
  messages: Pick<Messages, 'alert' | 'note'>;
  saving: Pick<Saving, 'filed'>;
  fileOpening: FileOpening;
  box: () => Pick<Storage, 'getItem' | 'setItem'>;
}) {
  /** Whether location and camera data are removed. */
  const clean = rememberedSwitch(box, CLEAN_KEY, false);
  /** The files that are in it by now, while it is made. */
  const saving: Signal<{ done: number; total: number } | null> = signal(null);
  let stop: AbortController | null = null;

  return { save, open, saving, clean, cancelSaving: () => stop?.abort() };

  /** Saves the project as a file for the user. */
  async function save() {
    // A second press would only make the same file again.
    if (stop) return;
    stop = new AbortController();
    const { signal: cancelled } = stop;
    try {
      const { file, name, unclean } = await packed({
        signal: cancelled,
        onProgress: (done, total) => {
          saving.value = total > 1 ? { done, total } : null;
        },
      });
      cancelled.throwIfAborted();
      saveFile(file, name);
      saves.filed();
      messages.note(savedWith(unclean));
    } catch (error) {
      if (!cancelled.aborted) messages.alert(strings.projectNotSaved({ why: explain(error) }));
    } finally {
      stop = null;
      saving.value = null;
    }
  }

  async function packed(work: Work) {
    // A file has no undo history, so it needs no photos that only the undo history shows.
    const history = store.mirror.peek();
    const { facts, videos } = factsOf(store, photosOf([history.present], history.shown));
    const read = facts.filter(({ id }) => engine.photos.has(id));
    const blobs: Map<string, Blob> = new Map();
    for (const { id } of read) blobs.set(id, engine.photos.get(id).file);
    for (const { key, file } of videos) blobs.set(videoKey(key), file);
    return packedProject({ history, facts: read, videos }, blobs, { clean: clean.on.peek(), work });
  }

  /** Opens a project file as another project. */
  function open(file: File) {
    return fileOpening.open(file, async ({ planner, photos: read, absent, watch }) => {
      const archive = await readArchive(file);
      const text = await archive.get('project.json')?.read({ most: TEXT.project, ...watch });
      if (!text) throw damaged('project.json is missing');
      const project = readProjectJson(await text.text(), planner);
      const films = project.videos.map(({ path }) => path);
      if (new Set(films).size < films.length) throw damaged('videos: two of them are one file');
      const facts = await read(project.photos, archive);
      if (facts.length === 0 && project.photos.length > 0) throw damaged('none of its photos can be read');
      const videos = await readVideos(project, archive, watch);
      const { name } = project.history.present;
      const { history, waiting } = withoutLost(project.history, facts, planner);
      for (const [i, id] of waiting.entries()) {
        const told = project.photos.find((photo) => photo.id === id);
        const frame = await absent(told ?? unknown(id), i + 1);
        facts.push(told ? { ...frame, name: told.name } : frame);
      }
      const present = { ...history.present, name: name || file.name.slice(0, -EXTENSION.length) };
      return {
        history: { ...history, present },
        album: new Map(facts.map((fact) => [fact.id, fact])),
        videos: new Map(videos.map((video) => [video.key, video])),
        records: [],
        unread: [],
        dropped: project.dropped,
      };
    });
  }
}

/** @param key of a video; it is not a photo id */
export function videoKey(key: string) {
  return `video ${key}`;
}

/**
 * @param blobs the files of its photos by id, and of its videos
 * @param how `version` of the history; `clean`: without metadata; `work`: each file counts twice, because it is read twice
 * @returns `unclean`: files whose place and date cannot be removed; null if the files are unchanged
 */
export async function packedProject(
  {
    history,
    facts,
    videos,
  }: { history: Beginning; facts: readonly Fact[]; videos: readonly (Omit<Video, 'file'> & { file: Blob })[] },
  blobs: ReadonlyMap<string, Blob>,
  { version, clean = false, work = {} }: { version?: number; clean?: boolean; work?: Work } = {},
): Promise<{ file: Blob; name: string; unclean: string[] | null }> {
  const { json, paths } = projectJson(
    history,
    facts.map((fact) => ({ ...fact, type: blobs.get(fact.id)?.type ?? '' })),
    videos,
    version,
  );
  const unclean: string[] = [];
  const entries = [];
  for (const [id, name] of paths) {
    work.signal?.throwIfAborted();
    work.onProgress?.(entries.length / 2, paths.size);
    const original = blobs.get(id) as Blob;
    const { blob, clean: cleaned } = clean ? await strippedOf(original) : { blob: original, clean: true };
    if (!cleaned)
      unclean.push(
        facts.find((fact) => fact.id === id)?.name ?? videos.find(({ key }) => videoKey(key) === id)?.name ?? name,
      );
    entries.push({ name, blob });
  }
  const file = await archiveOf([{ name: 'project.json', blob: new Blob([json]) }, ...entries], {
    signal: work.signal,
    onProgress: (done, total) => work.onProgress?.((paths.size * (1 + done / total)) / 2, paths.size),
  });
  return {
    file: new Blob([file], { type: 'application/zip' }),
    name: projectFileName(history.present.name),
    unclean: clean ? unclean : null,
  };
}

/** @param name of a project */
export function projectFileName(name: string) {
  return fileNameOf([name], EXTENSION.slice(1), strings.untitled);
}

/**
 * Keeps the places of missing photos on pages, up to a limit.
 * @param facts of the photos that are there
 * @returns `waiting`: missing photos with reserved places
 */
function withoutLost(
  history: Beginning,
  facts: readonly Fact[],
  planner: Pick<Planner, 'createEditor'>,
): { history: Beginning; waiting: string[] } {
  const here = new Set(facts.map(({ id }) => id));
  const lost = [...photosOf([history.present], history.shown)].filter((id) => !here.has(id));
  const shown = new Set(sheetsOf(history.present).flatMap(({ page }) => page.panels.map(({ photo }) => photo)));
  const waits = new Set(lost.filter((id) => shown.has(id)).slice(0, PLACES_FOR_LOST));
  const gone = lost.filter((id) => !waits.has(id));
  if (gone.length === 0) return { history, waiting: [...waits] };
  const editing = createEditing(planner.createEditor(), history);
  return { history: editing.apply({ type: 'forget-photos', ids: gone }), waiting: [...waits] };
}

/** @returns an entry for a photo without metadata */
function unknown(id: string): FilePhoto {
  return { id, name: id, path: '', type: '', subjects: null, measured: true, rank: null, like: null, absent: true };
}

async function readVideos({ videos }: FileProject, archive: Archive, watch: Hands['watch']) {
  const read = [];
  for (const { path, type, ...video } of videos) {
    // Without its video a frame is a photo like others.
    const blob = await archive
      .get(path)
      ?.read(watch)
      .catch((error) => {
        if (error.code !== 'damaged-project') throw error;
        return null;
      });
    if (blob) read.push({ ...video, file: new File([blob], video.name, { type }) });
  }
  return read;
}
