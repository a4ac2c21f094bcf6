/**
 * Subject detection: photos of the current page first, then other pages; faces and objects in parallel. Face detection
 * starts when the photos of the first page are read, if its model is already loaded (`expect`). All other detection
 * starts when the page is visible and the user rests, at low priority. While photos are read, only faces are detected:
 * on the visible page, then in other photos. The first page is planned again with them.
 */

import { computed, effect, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { showsPerson } from '../engine/detector.ts';
import { photosOn } from '../engine/sheets.ts';
import type { Messages } from '../ui/messages.ts';
import type { Progress, Store } from '../document/store.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Detection } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { Signal } from '@preact/signals';

export type Subjects = ReturnType<typeof createSubjects>;

/**
 * Detected subjects of a photo. A failure counts as no result. `closer`: the first look asks for a closer one. `closely`:
 * the closer look is done. `draft`: they were found in the draft of the photo.
 */
type Looked = {
  faces?: readonly Detection[];
  objects?: readonly Detection[];
  closer?: boolean;
  closely?: boolean;
  draft?: boolean;
};
type Lane = 'faces' | 'objects';

/** Without the detectors none of the other photos can be looked at. */
const FATAL = new Set(['detector-missing', 'worker-lost', 'detector']);

/** Maximum milliseconds between the first page and the detection for its second plan. A shuffle needs the workers first. */
const SOON = 400;

/**
 * @param app `painted` and `unsettled` read signals: whether the current page is on the screen, and whether it is the first
 *   page that may be planned again. Detection waits for a rest of such a page only for a moment. `wanted`: whether detection is
 *   enabled. `onFound` is called with new subjects of a photo on the page.
 */
export function createSubjects({
  store,
  messages,
  engine,
  painted,
  unsettled = () => false,
  onFound,
  wanted = true,
  scheduler,
  window = globalThis.window,
}: {
  store: Store;
  messages: Messages;
  engine: Pick<
    Engine,
    'prepareDetectors' | 'facesReady' | 'findFaces' | 'findMoreFaces' | 'findObjects' | 'hasPhoto' | 'isDraft'
  >;
  painted: () => boolean;
  unsettled?: () => boolean;
  onFound: () => void;
  wanted?: boolean;
  scheduler: Pick<Scheduler, 'background'>;
  window?: Pick<Window, 'addEventListener' | 'navigator'>;
}) {
  const known: Map<string, Looked> = new Map();
  const progress: Signal<Progress | null> = signal(null);
  const off = signal(!wanted);
  const running = signal(new Set() as ReadonlySet<Lane>);
  /** Whether the detectors could not be loaded, and whether a message was shown. */
  const lacking = { now: false, said: false };
  /** Bumped when `known` changes. */
  const round = signal(0);
  /** Whether the user is not browsing pages. */
  const calm = signal(true);
  /** The last version of the page that was on the screen for a moment. Its panels may be drawn once more meanwhile. */
  const visible = signal('');

  const onPage = computed(() => photosOn(store.page.value ? [store.page.value] : []));
  const photos = computed(() => {
    round.value;
    const beside = photosOn(store.sheets.value);
    const rank = (id: string) => (onPage.value.has(id) ? 0 : beside.has(id) ? 1 : 2);
    const read = store.facts.value.filter(({ id, meta, looked }) => meta !== null && !looked && engine.hasPhoto(id));
    return read.map(({ id }) => id).sort((a, b) => rank(a) - rank(b));
  });
  /** Whether everything is found that will be. */
  const settled = computed(
    () =>
      off.value ||
      store.page.value === null ||
      (store.reading.value === null && running.value.size === 0 && !due('faces') && !due('objects')),
  );

  /** Whether faces were looked for in every photo, and objects in the photos of the page. */
  const faced = computed(() =>
    photos.value.every((id) => (onPage.value.has(id) ? !unsearched(id) : looked(id).faces !== undefined)),
  );

  /** Whether every photo was looked at by both, which most crops wait for; closer looks may go on. */
  const searched = computed(() => off.value || store.page.value === null || !photos.value.some(unsearched));

  let shown = '';
  let appeared = '';
  let stop = new AbortController();
  effect(() => {
    const version = store.sketch.value ? '' : store.version.value;
    if (store.page.value === null || version === shown) return;
    shown = version;
    stop.abort();
    stop = new AbortController();
    calm.value = false;
    const rest = () => {
      calm.value = true;
    };
    scheduler.background(rest, stop);
  });

  effect(() => {
    const version = store.version.value;
    if (store.page.value === null || appeared === version || !painted()) return;
    appeared = version;
    const show = () => {
      visible.value = version;
    };
    scheduler.background(show, { latest: performance.now() + SOON });
  });

  effect(() => {
    if (off.value || store.page.value === null) return;
    // The photos arrived without preparation. Waiting for faces is worth the delay.
    if (store.sketch.value) engine.prepareDetectors();
    if (!painted() && !early() && !soon()) return;
    // The slower detection starts first.
    for (const lane of ['objects', 'faces'] as const) if (!running.value.has(lane) && next(lane)) void run(lane);
  });

  window?.addEventListener('online', () => {
    if (lacking.now) off.value = false;
    lacking.now = false;
  });

  return { progress, settled, faced, searched, expect };

  /** Loads the models while the user chooses photos. */
  function expect() {
    if (!off.peek() && store.tray.peek().length === 0) engine.prepareDetectors(true);
  }

  /** Whether faces can be found before the first page. */
  function early() {
    return store.sketch.value && engine.facesReady();
  }

  /** Whether the first page was visible for a moment, and waits for the detection of all photos. */
  function soon() {
    return unsettled() && !store.sketch.value && visible.value === store.version.value;
  }

  /** The photo to look at now; while a page is drawn the cores are the page's. */
  function next(lane: Lane): string | undefined {
    return (painted() && calm.value) || early() || soon() ? due(lane) : undefined;
  }

  /**
   * The photo to look at next. During reading, only faces are detected, and none in frames of other pages, because a long
   * video is read for half a minute. A closer look waits for the objects of its photo. If its photo is not on the page, it
   * waits for the first look at every photo.
   */
  function due(lane: Lane): string | undefined {
    if (store.sketch.value) return lane === 'faces' ? photos.value.find((id) => !looked(id).faces) : undefined;
    if (store.reading.value !== null) {
      const album = store.album.peek();
      const isWanted = (id: string) => onPage.value.has(id) || album.get(id)?.video === undefined;
      return lane === 'faces' ? photos.value.find((id) => isWanted(id) && !looked(id).faces) : undefined;
    }
    const first = photos.value.find((id) => looked(id)[lane] === undefined);
    if (first !== undefined || lane === 'objects') return first;
    const isSearching = photos.value.some(unsearched);
    return photos.value.find((id) => needsCloserLook(looked(id)) && (onPage.value.has(id) || !isSearching));
  }

  async function run(lane: Lane) {
    running.value = new Set([...running.peek(), lane]);
    try {
      for (let id = next(lane); id !== undefined && !off.peek(); id = next(lane)) {
        count();
        const draft = engine.isDraft(id);
        const found = await look(lane, id);
        // The other lane may have looked at the same photo meanwhile.
        known.set(id, { ...looked(id), ...found, draft });
        tell(id);
        // The first page is planned on them.
        if (store.sketch.peek()) store.faced.value = new Set([...store.faced.peek(), id]);
        round.value += 1;
      }
    } catch (error) {
      if (!off.peek()) giveUp((error as { code?: string }).code === 'detector-missing');
    } finally {
      running.value = new Set([...running.peek()].filter((other) => other !== lane));
      count();
    }
  }

  /**
   * The detection result of a photo. The result of a draft ends with the draft. A draft without faces has enough pixels for
   * the first look, so only the closer look follows.
   */
  function looked(id: string): Looked {
    const found = known.get(id) ?? {};
    if (!found.draft || engine.isDraft(id)) return found;
    return found.faces?.length === 0 ? { faces: [], closer: found.closer } : {};
  }

  function unsearched(id: string) {
    const { faces, objects } = looked(id);
    return !faces || !objects;
  }

  /** whether a later attempt may succeed */
  function giveUp(missing: boolean) {
    const away = missing && window?.navigator.onLine === false;
    if (!lacking.said) messages.note(away ? strings.noDetectorOffline : strings.noDetector);
    lacking.said = true;
    lacking.now = missing;
    off.value = true;
    // A first page must not wait for faces that are not detected.
    if (store.sketch.peek()) store.faced.value = new Set(store.tray.peek().map(({ id }) => id));
  }

  /** Progress of the first looks; the closer ones change little. */
  function count() {
    const left = off.peek() ? 0 : photos.peek().filter(unsearched).length;
    const total = Math.max(progress.peek()?.total ?? 0, left);
    progress.value = left > 0 && running.peek().size > 0 ? { done: total - left, total } : null;
  }

  /** @returns the new subjects */
  async function look(lane: Lane, id: string): Promise<Looked> {
    const { faces: before, objects = [] } = looked(id);
    try {
      if (lane === 'objects') return { objects: await engine.findObjects(id) };
      if (before) return { faces: await engine.findMoreFaces(id, before, objects), closely: true };
      const { boxes, closer } = await engine.findFaces(id);
      return { faces: boxes, closer };
    } catch (error) {
      if (FATAL.has((error as { code: string }).code)) throw error;
      // One photo that cannot be looked at is framed by contrast.
      return lane === 'objects' ? { objects: [] } : { faces: before ?? [], closely: true };
    }
  }

  /**
   * Stores the subjects of a photo. The page follows when both lanes have looked at its photo. Faces count at once while
   * photos are read, and in photos that are not on the page.
   */
  function tell(id: string) {
    const found = known.get(id) ?? {};
    const { faces, objects } = found;
    const fact = store.album.peek().get(id);
    const isShown = onPage.peek().has(id);
    if (!faces || !(objects || store.reading.peek() || !isShown) || !fact?.meta) return;
    // Lettering was found when the photo was read.
    const lettering = fact.meta.subjects.filter(({ label }) => label === 'lettering');
    const subjects = [...faces, ...(objects ?? []), ...lettering];
    const same = JSON.stringify(fact.meta.subjects) === JSON.stringify(subjects);
    // Results are saved, so the next visit does not repeat the detection.
    const looked = !!objects && !needsCloserLook(found);
    if (!same || looked)
      store.know({ ...fact, meta: same ? fact.meta : { ...fact.meta, subjects }, ...(looked ? { looked } : {}) });
    if (!same && isShown) onFound();
  }
}

/** Whether a closer look is due. It waits for the objects, because it searches the heads of persons. */
function needsCloserLook({ objects, closer, closely }: Looked) {
  return !closely && objects !== undefined && (closer || showsPerson(objects));
}
