/**
 * Imports photos. The page is laid out for all of them at once, and its panels fill while they are read, so that
 * nothing jumps. A file that cannot be read is named, and the rest go on.
 */

import { batch } from '@preact/signals';
import { mayMove, pictureEnds } from '../engine/animation-times.ts';
import { filmsAmong } from '../engine/film-kinds.ts';
import { strings } from '../strings/strings.ts';
import { createAlbumNaming } from './album-naming.ts';
import { createFirstPage } from './first-page.ts';
import { inFolderOrder } from './folders.ts';
import { FRAMES, createFrames } from './frames.ts';
import { createIntake } from './intake.ts';
import { MOST } from '../document/limits.ts';
import { headersOf, sizesIn } from './headers.ts';
import { decodeThumbnail } from '../engine/photo-header.ts';
import { photosOn } from '../engine/sheets.ts';
import { fetchSamples } from './samples.ts';
import type { Headers } from './headers.ts';
import type { Messages } from '../ui/messages.ts';
import type { Fact, Video } from '../document/album.ts';
import type { Pages } from '../document/pages.ts';
import type { Action } from '../document/project.ts';
import type { PlaceNames } from './place-names.ts';
import type { Store } from '../document/store.ts';

/** a file, and the photos that it becomes */
type Source = { file: File; ids: readonly string[]; video: Video | null };
type Engine = Pick<
  import('../engine/engine.ts').Engine,
  'importPhoto' | 'importDraft' | 'isDraft' | 'importVideo' | 'forgetPhoto' | 'ready' | 'facesReady'
>;
export type Reading = ReturnType<typeof createReading>;

/** @param app `prefix` begins the ids of photos; `detects`: whether faces are detected; `places` names places by GPS data */
export function createReading({
  store,
  pages,
  engine,
  messages,
  prefix,
  detects,
  places,
}: {
  store: Store;
  pages: Pages;
  engine: Engine;
  messages: Messages;
  prefix?: string;
  detects?: boolean;
  places?: PlaceNames;
}) {
  let clicks = 0;
  /** The photos of the last plan, to see whether another is due. */
  let planned = '';
  /** The undo group of the photos being read; null for the first ones, which cannot be undone. */
  let gesture = null as string | null;
  /** The message about a missing page, closed by the next page. */
  /** Number of files being read. */
  let files = 0;

  /** Cancels reading. */
  let stop: AbortController | null = null;

  const intake = createIntake({ store, pages, engine, messages, prefix });
  const frames = createFrames({ store, engine, intake, messages });
  const naming = createAlbumNaming({ store, located: places?.names });
  const firstPage = createFirstPage({ store, pages, facesReady: engine.facesReady, isDraft: engine.isDraft, detects });

  return {
    addFiles,
    addSamples,
    resume,
    resample,
    cancel,
    use,
    remove,
    removeAll,
    edit,
    keepShown,
    freshIds: intake.freshIds,
    count: intake.count,
    /** The automatic name of the project; empty without information. */
    automaticName: naming.automatic,
    title: naming.title,
    moments: naming.moments,
    /** Whether the first page is a moment away. */
    near: firstPage.near,
    /** The first page, if it was composed, and the time. */
    composed: firstPage.composed,
  };

  /**
   * @param credits the authors to name, by file name
   * @param moments times in seconds of dialogue in a video
   */
  async function addFiles(
    given: readonly File[],
    credits?: ReadonlyMap<string, string>,
    moments: ReadonlyMap<File, readonly number[]> = new Map(),
  ) {
    if (given.length === 0) return;
    store.arriving.value += given.length;
    let read: Promise<void> | undefined;
    await onTable(given, credits, (sources) => {
      read = readAll(sources, moments);
    }).finally(() => {
      store.arriving.value -= given.length;
    });
    await read;
  }

  /**
   * @param begin receives the new tray before any of it is drawn, because drawing the sketch takes longer than
   *   distributing the files. Not called without a planner
   */
  async function onTable(
    given: readonly File[],
    credits: ReadonlyMap<string, string> | undefined,
    begin: (sources: Source[]) => void,
  ): Promise<void> {
    try {
      // Nothing can be laid out before the planner is there.
      await engine.ready;
    } catch {
      return;
    }
    const moving: Map<File, number> = new Map();
    // One after the other, so that the memory holds at most one of them.
    for (const file of given.filter(mayMove)) moving.set(file, (await pictureEnds(file)).length);
    const isEmpty = () => store.tray.peek().length === 0;
    // The first page keeps the layout of its sketch, so the sketch must suit the photos.
    const headers = headersOf(isEmpty() ? given : []);
    const [films, sizes] = await Promise.all([filmsAmong(given), sizesIn(headers)]);
    const first = isEmpty();
    // As one change: hundreds one by one would each be looked at by all that depends on the album.
    let room = MOST.photos - store.tray.peek().length;
    const sources = batch(() =>
      inFolderOrder(given).flatMap((file) => {
        const frames = framesOf(moving.get(file) ?? 0, films.has(file));
        if (Math.max(1, frames) > room) return [];
        room -= Math.max(1, frames);
        return [sourceOf(file, frames, { credit: credits?.get(file.name), size: sizes.get(file) })];
      }),
    );
    if (sources.length < given.length)
      messages.alert(strings.tooManyPhotos({ n: given.length - sources.length, most: strings.decimal(MOST.photos) }));
    if (sources.length === 0) return;
    const ids = sources.flatMap((source) => source.ids);
    files = (store.reading.peek() ? files : 0) + given.length;
    naming.begin(sources);
    places?.begin(sources);
    intake.count(0, ids.length);
    if (first) {
      gesture = null;
      store.change({ type: 'add-photos', ids, silent: true });
      firstPage.sketch();
    } else {
      // A page that is there stays as it is until the new photos are known to be any good.
      gesture ??= `add-${ids[0]}`;
      store.change({ type: 'add-photos', ids, gesture });
    }
    begin(sources);
    if (first) void showThumbnails(sources, headers);
  }

  /** Fills the sketch with the thumbnails that cameras store in their files. */
  async function showThumbnails(sources: Source[], headers: Headers) {
    const shown = photosOn(store.sheets.peek());
    const photos = sources.filter(({ ids, video }) => !video && shown.has(ids[0]));
    const found = await Promise.all(
      photos.map(async ({ ids, file }) => {
        const header = await headers.get(file);
        return [ids[0], header && (await decodeThumbnail(header))] as const;
      }),
    );
    store.thumbnails.value = new Map(found.flatMap(([id, thumbnail]) => (thumbnail ? [[id, thumbnail]] : [])));
  }

  /**
   * @param pictures of an animation
   * @returns the frames to extract at first, empty for a photo
   */
  function framesOf(pictures: number, film: boolean): number {
    return film || pictures > 0 ? Math.min(FRAMES, pictures || FRAMES) : 0;
  }

  /** @param count of its frames */
  function sourceOf(file: File, count: number, more: Pick<Fact, 'credit' | 'size'>): Source {
    const video = count > 0 ? frames.open(file, { frames: count }) : null;
    const ids = video ? video.ids : intake.freshIds(1);
    for (const id of ids) store.know({ id, name: file.name, meta: null, measures: null, ...more });
    return { file, ids, video };
  }

  /** Undo group of later results of the same import. */
  function stepOf() {
    return gesture === null ? { silent: true as const } : { gesture };
  }

  async function readAll(sources: Source[], moments: ReadonlyMap<File, readonly number[]>) {
    const signal = stopSignal();
    await Promise.all(
      sources.map((source) =>
        source.video
          ? frames.read(source.video, { signal, step: stepOf, moments: moments.get(source.file) })
          : intake.readPhoto(source.ids[0], source.file, signal),
      ),
    );
    if (!store.reading.peek()) settle();
  }

  /**
   * Reads photos that are already in the tray. Their measurements stay.
   * @param films keys of videos whose frames are taken once more
   */
  async function resume(photos: readonly { id: string; file: File }[], films: readonly string[] = []) {
    const videos = films.flatMap((key) => store.videos.peek().get(key) ?? []);
    const count = videos.reduce((sum, { ids }) => sum + ids.length, photos.length);
    if (count === 0) return;
    intake.count(0, count);
    planned = inUse();
    // Stopping it would take them out of the tray.
    const { signal } = new AbortController();
    await Promise.all([
      ...photos.map(({ id, file }) => intake.readPhoto(id, file, signal)),
      ...videos.map((video) => frames.read(video, { signal })),
    ]);
    if (!store.reading.peek()) settle();
  }

  /**
   * Replaces the frames of a video, as one undo step.
   * @param wish seconds, and how many
   */
  async function resample(key: string, wish: { start: number; end: number; frames: number }) {
    if (store.reading.peek()) return;
    if (store.tray.peek().length + wish.frames > MOST.photos) {
      messages.alert(strings.tooManyPhotos({ n: 1, most: strings.decimal(MOST.photos) }));
      return;
    }
    clicks += 1;
    gesture = `video-${clicks}`;
    await frames.resample(key, wish, { gesture, signal: stopSignal() });
    if (!store.reading.peek()) settle();
  }

  function stopSignal() {
    stop ??= new AbortController();
    return stop.signal;
  }

  /** Cancels reading. Finished photos stay. */
  function cancel() {
    stop?.abort();
  }

  /** All are read: duplicates are set aside and the order of time is known, which may ask for another page. */
  function settle() {
    const step = gesture;
    gesture = null;
    stop = null;
    messages.noneUsed(false);
    naming.settle(step);
    if (store.photos.peek().length === 0) {
      store.change({ type: 'no-page', silent: true });
      // For a single file the error message is enough.
      if (files > 1) messages.noneUsed(true);
    } else if (step === null) {
      if (!firstPage.finish()) keepShown();
    } else if (planned !== inUse()) {
      pages.refit({ grow: true, gesture: step });
    }
    planned = inUse();
  }

  /** Keeps the near-duplicate on the page in use, instead of one that was read or searched later. */
  function keepShown() {
    const shown = photosOn(store.sheets.peek());
    const verdicts = [...store.verdicts.peek().values()];
    const chosen = new Set(store.tray.peek().flatMap(({ id, use }) => (typeof use === 'boolean' ? [id] : [])));
    const excluded = verdicts.filter(({ id, kept }) => !kept && shown.has(id) && !chosen.has(id));
    const groups = new Set(excluded.map(({ group }) => group));
    const alike = verdicts.filter(({ group, kept, id }) => groups.has(group) && (kept || shown.has(id)));
    if (alike.length === 0) return;
    const uses = Object.fromEntries(alike.map(({ id }) => [id, shown.has(id)]));
    store.change({ type: 'use-photos', uses, silent: true });
  }

  function inUse() {
    return store.photos
      .peek()
      .map(({ id }) => id)
      .join();
  }

  /** The album that ships with the program. */
  async function addSamples() {
    if (store.fetching.peek()) return;
    store.fetching.value = true;
    const album = await fetchSamples().catch(() => null);
    store.fetching.value = false;
    if (album) await addFiles(album.files, album.credits);
    else messages.alert(strings.noSamples);
  }

  function use(id: string, on: boolean) {
    edit({ type: 'use-photos', uses: { [id]: on } }, (gesture) => pages.refit({ grow: on, gesture }));
  }

  function remove(id: string) {
    removeAll([id]);
  }

  function removeAll(ids: readonly string[]) {
    edit({ type: 'remove-photos', ids }, (gesture) => pages.refit({ grow: false, gesture }));
  }

  /**
   * A change of the tray and the edit of the page that follows from it, as one step.
   * @param control whose changes one after the other are one step
   */
  function edit(action: Action, follow: (gesture: string) => void, control?: string) {
    if (control === undefined) clicks += 1;
    const gesture = control ?? `tray-${clicks}`;
    const before = store.project.peek();
    store.change({ ...action, gesture });
    if (store.project.peek() === before) return;
    planned = inUse();
    follow(gesture);
  }
}
