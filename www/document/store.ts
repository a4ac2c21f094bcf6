/**
 * The state as signals. `change` is the only way to change the history; everything else is derived, or belongs to
 * the session and is never saved.
 */

import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { chronological, inFilmOrder, isUsed, reasonsOf, unreadMeta, withFacts } from './album.ts';
import { failure } from '../engine/protocol.ts';
import { createEditing } from './editing.ts';
import { EMPTY_MIRROR } from './history.ts';
import { freshPlace } from './place.ts';
import type { Thumbnail } from '../engine/photo-header.ts';
import type { Planner, Unseen } from '../engine/core.ts';
import type { Intent, LayoutChoice, PageSettings, Template } from '../engine/types.ts';
import type { Place } from './place.ts';
import type { Album, Fact, Verdict, Video } from './album.ts';
import type { Editing } from './editing.ts';
import type { Change, Mirror } from './history.ts';
import type { TrayItem } from './project.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

export type { Planner };
export type Store = ReturnType<typeof createStore>;
export type Progress = { done: number; total: number };

/** @param onRefused receives the error of an edit that the core rejects */
export function createStore({ onRefused = () => {} }: { onRefused?: (error: Error) => void } = {}) {
  const mirror = signal(EMPTY_MIRROR);
  /** Contains the history; null until the core is loaded, or nothing was changed. */
  let editing: Editing | null = null;
  /** Changes before the core was loaded. */
  let early: Change[] = [];
  /** It changes together with the history, so a history is never saved in another place. */
  const place = signal(freshPlace());
  const album: Signal<Album> = signal(new Map());
  const planner: Signal<Planner | null> = signal(null);
  /** The photos being read; null when all are. */
  const reading: Signal<Progress | null> = signal(null);
  const looking: Signal<ReadonlyMap<string, { name: string; part: number }>> = signal(new Map());

  /** The videos that photos in the tray were taken from. */
  const videos: Signal<ReadonlyMap<string, Video>> = signal(new Map());

  /** The files of photos that are still being read. */
  const originals: Map<string, File> = new Map();

  /** Whether the page is a sketch of the first page: empty panels until its photos are analysed. */
  const sketch = signal(false);

  /** Thumbnails from the files of photos that are not read yet, for the sketch. */
  const thumbnails: Signal<ReadonlyMap<string, Thumbnail>> = signal(new Map());

  /** Photos with finished face detection before the first page. */
  const faced: Signal<ReadonlySet<string>> = signal(new Set());

  /** Number of chosen files that are not in the tray yet, because the planner is not ready. */
  const arriving = signal(0);

  /** Whether the sample album is on its way. */
  const fetching = signal(false);

  const project = computed(() => mirror.value.present);
  /** The page history: the last state of each page, in the order in which the pages were first shown. */
  const pageHistory = computed(() => mirror.value.shown);
  /** The versions of the current page. In a project of one page, the whole page history. */
  const versions = computed(() => pageHistory.value.filter(({ sheet = 0 }) => sheet === project.value.sheet));
  const page = computed(() => project.value.page);
  /** Names the version of the page, in whatever project it is: ids of pages are used again in each. */
  const version = computed(() => `${place.value.id} ${project.value.pageId}`);
  const others = computed(() => project.value.others);
  const at = computed(() => project.value.at);
  /** All pages of the storyboard in order, including the current one; empty without pages. */
  const sheets = computed(() =>
    page.value ? others.value.map((sheet) => sheet.page).toSpliced(at.value, 0, page.value) : [],
  );
  let arranged: readonly TrayItem[] = [];
  /** The photos in the tray. Frames of a video arrive unordered, because frames of the first page come first. */
  const tray = computed(() => {
    const items = inFilmOrder(project.value.tray, album.value);
    // If the order of the album has not changed, the items keep their object identity.
    if (items.length !== arranged.length || items.some((item, i) => item !== arranged[i])) arranged = items;
    return arranged;
  });
  /** Videos with a frame in the tray. Undo removes a video together with its frames. */
  const films = computed(() => {
    const there = new Set(tray.value.map(({ id }) => id));
    return [...videos.value.values()].filter(({ ids }) => ids.some((id) => there.has(id)));
  });

  /** Facts of the tray, in its order. */
  const facts = computed(() => tray.value.flatMap(({ id }) => album.value.get(id) ?? []));

  /** Known subject masks by photo: corrected or detected. */
  const masks: ReadonlySignal<ReadonlyMap<string, string>> = computed(() => {
    const own = new Map(project.value.tray.map(({ id, mask }) => [id, mask]));
    return new Map(
      [...album.value].flatMap(([id, { meta }]) => {
        const mask = own.get(id) ?? meta?.mask;
        return mask ? [[id, mask] as const] : [];
      }),
    );
  });

  /** Measurements of the photos that were read. */
  const measured = computed(() =>
    facts.value.flatMap(({ id, name, measures, video, meta }) => {
      if (!measures) return [];
      const faces = meta?.subjects.flatMap(({ expression }) => expression ?? []) ?? [];
      return [{ id, name, film: video, faces, ...measures }];
    }),
  );

  let judged: ReadonlyMap<string, Verdict> = new Map();
  const duplicateThreshold = computed(() => project.value.alike);
  /**
   * The verdict on each photo. It is available after all photos are read, so that photos do not change back and forth.
   */
  const verdicts = computed(() => {
    if (!planner.value || reading.value) return judged;
    judged = new Map(
      planner.value.choose(measured.value, duplicateThreshold.value).map((verdict) => [verdict.id, verdict]),
    );
    return judged;
  });

  const reasons = computed(() => reasonsOf(tray.value, album.value, verdicts.value));

  const isDated = computed(() => project.value.order === 'time');
  /** The photos in use, in order, for the planner. It changes only with the tray and the measurements. */
  const photos = computed(() => {
    const items = new Map(tray.value.map((item) => [item.id, item]));
    const used = new Set(tray.value.filter((item) => isUsed(item, verdicts.value)).map(({ id }) => id));
    const list = facts.value.filter(({ id }) => used.has(id));
    // During an import the order of the files stays, because each new photo would rearrange the page.
    const dated = !reading.value && isDated.value;
    return (dated ? chronological(list) : list).map(({ id, meta, video, absent, size }) => {
      const known = meta ?? unreadMeta(id, size);
      const { focus, starred, mask } = items.get(id) ?? {};
      const more = {
        ...((focus || starred || mask) && { focus: focus ?? null, starred: starred ?? false }),
        ...(mask && { mask }),
        ...(video !== undefined && { frame: true }),
        ...(absent && { absent: true }),
      };
      return withFacts(known, more);
    });
  });

  /** The photos of the pages shown and the place of the current one, as text. */
  const shown = computed(() => {
    const { shown, present } = mirror.value;
    if (!present.page || shown.length === 0) return '';
    return JSON.stringify([
      present.sheet,
      shown.map(({ page, sheet }) => [sheet, page.panels.map(({ photo }) => photo)]),
    ]);
  });
  /** The photos in use that no page has shown yet, and why. Empty until there is a page. */
  const unseen: ReadonlySignal<ReadonlyMap<string, Unseen>> = computed(() => {
    if (!planner.value || reading.value || shown.value === '' || size.value === '') return new Map();
    const used = photos.value;
    const list = untracked(() => (editing ?? begun()).plans(used).unseen());
    return new Map(list.map(({ photo, why }) => [photo, why]));
  });

  /** Custom layouts, in full. */
  const own: ReadonlySignal<readonly Template[]> = computed(() => project.value.ownLayouts);
  /** The page size, the only setting that affects the choice of layouts. */
  const size = computed(() => `${project.value.settings.width} ${project.value.settings.height}`);
  /** Layouts to choose from: custom ones, and built-in ones that are good for the page. */
  const layouts = computed(() => {
    const [width, height] = size.value.split(' ').map(Number);
    return planner.value?.listLayouts({ page: { width, height }, own: [...own.value] }) ?? [];
  });
  /** Layout and paper of the page, as text. Other changes of the page keep its geometry. */
  const shape = computed(() => page.value && JSON.stringify([page.value.layout, page.value.page]));
  /** Layout and merged panels of the page, as text. */
  const grouping = computed(() => page.value && JSON.stringify([page.value.layout, page.value.merges]));
  const ofShape = <T>(make: (planner: Planner, layout: LayoutChoice, paper: PageSettings) => T) =>
    computed(() => {
      const [core, now] = [planner.value, shape.value && page.peek()];
      return core && now ? make(core, now.layout, now.page) : null;
    });
  /** Possible changes of the layout of the page. */
  const layoutFacts = ofShape((core, layout, paper) => core.layoutFacts(layout, paper));
  const styles = computed(() => planner.value?.styles() ?? []);
  const geometry = ofShape((core, layout, paper) => core.geometry(layout, paper));

  effect(() => {
    if (planner.value) untracked(() => early.splice(0).forEach(change));
  });

  return {
    /** A new object with each change of the history. */
    mirror: computed(() => mirror.value) as ReadonlySignal<Mirror>,
    canUndo: computed(() => mirror.value.undos > 0),
    canRedo: computed(() => mirror.value.redos > 0),
    /** A number that changes with each undo step, and when one is undone or redone. */
    step: computed(() => mirror.value.step),
    pageHistory,
    versions,
    /** Index of the current page among its versions, or -1. */
    versionIndex: computed(() =>
      page.value === null ? -1 : versions.value.findIndex(({ id }) => id === project.value.pageId),
    ),
    /** The editor with the history, for saving, replacing and restoring it. */
    editing: () => editing,
    /** Plans pages of the project from the photos in use. Throws while there is no planner. */
    plans: () => (editing ?? begun()).plans(photos.peek()),
    /** @returns the page that an intent would make the current page; null if the page stays */
    preview: (intent: Intent) => (editing ?? begun()).preview(intent, photos.peek()),
    /** @returns why panels of the page cannot be merged or joined; null without a page */
    obstacles: (panels: readonly number[]) =>
      grouping.value === null ? null : untracked(() => (editing ?? begun()).obstacles(panels)),
    /** Ids that were never used, nor any above them: of a page, and of a place in the storyboard. */
    fresh: () => (editing ?? begun()).fresh(),
    /** Storage place of the history. */
    place: computed(() => place.value) as ReadonlySignal<Place>,
    album,
    videos,
    films,
    originals,
    planner,
    reading,
    sketch,
    thumbnails,
    faced,
    arriving,
    fetching,
    project,
    page,
    version,
    sheets,
    tray,
    facts,
    masks,
    measured,
    verdicts,
    /** Why photos are used or not. No entry: the user's choice. */
    reasons,
    /** Videos whose shots are being detected, by key: progress from 0 to 1. */
    looking,
    photos,
    unseen,
    own,
    layouts,
    layoutFacts,
    styles,
    geometry,
    change,
    load,
    /** Drops the measurements of photos that are in no state of the history. */
    unknow: (ids: readonly string[]) => {
      album.value = new Map([...album.value].filter(([id]) => !ids.includes(id)));
    },
    know: (fact: Fact) => {
      album.value = new Map(album.value).set(fact.id, fact);
    },
  };

  /** Applies a change. Throws `invalid-document` for an invalid change, and changes nothing. */
  function change(change: Change) {
    if (editing === null && planner.peek() === null) early.push(change);
    else mirror.value = after(change);
  }

  function after(change: Change): Mirror {
    const own = editing ?? begun();
    try {
      return own.apply(change, photos.peek());
    } catch (error) {
      // An editor that broke is of no use any more. An error of the core has a code.
      if ((error as { code?: unknown }).code === undefined) revive(own);
      onRefused(error as Error);
      throw error;
    }
  }

  function revive(own: Editing) {
    try {
      own.revive(fresh());
      mirror.value = own.mirror();
    } catch {
      // The next change tries it again.
    }
  }

  /**
   * Replaces the document.
   * @param other `editing`: its editor, null for an empty project; `place`: its storage place, omitted if the project
   *   stays the same
   */
  function load(other: { editing: Editing | null; album: Album; videos: ReadonlyMap<string, Video>; place?: Place }) {
    batch(() => {
      editing = other.editing;
      early = [];
      place.value = other.place ?? place.peek();
      album.value = other.album;
      videos.value = other.videos;
      mirror.value = editing?.mirror() ?? EMPTY_MIRROR;
    });
  }

  function begun() {
    editing = createEditing(fresh());
    return editing;
  }

  function fresh() {
    const core = planner.peek();
    if (!core) throw failure('core-missing', 'The program is not loaded yet.');
    return core.createEditor();
  }
}
