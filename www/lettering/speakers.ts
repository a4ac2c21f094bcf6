/**
 * Speakers of videos: a balloon on a frame with several faces points at the face whose lips move. The lips are compared
 * over the frames around it, once the page is at rest.
 */

import { computed, effect, signal } from '@preact/signals';
import { sheetsOf } from '../engine/sheets.ts';
import { setWords } from './word-planning.ts';
import type { Signal } from '@preact/signals';
import type { Fact } from '../document/album.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Detection, PageDocument, Word } from '../engine/types.ts';

/** Seconds before the start of a subtitle, and after it, within which a frame shows its speaker. */
const NEAR = { before: 0.5, after: 5 } as const;

/** @param app `ready` reads signals: whether no other work is waiting. `settled` places text items of a page again. */
export function createSpeakers({
  store,
  engine,
  settled,
  ready,
}: {
  store: Store;
  engine: Pick<Engine, 'watchLips'>;
  settled: (page: PageDocument, only: readonly number[]) => PageDocument;
  ready: () => boolean;
}) {
  /** Frames that were compared, or cannot be. */
  const seen = signal(new Set()) as Signal<ReadonlySet<string>>;
  const running = signal(false);
  const due = computed(() => {
    const words = store.sheets.value.flatMap((page) => (page.words ?? []).filter(speaks));
    const found = words.find(({ photo, cue }) => {
      const fact = store.album.value.get(photo ?? '');
      if (!fact || seen.value.has(fact.id) || facesOf(fact).length < 2) return false;
      const moment = momentOf(fact);
      const start = Number(/([\d.]+)\/\d+$/.exec(cue ?? '')?.[1] ?? NaN);
      return moment !== null && moment.time >= start - NEAR.before && moment.time <= start + NEAR.after;
    });
    return found?.photo ?? null;
  });

  effect(() => {
    if (!running.value && due.value && ready()) void run(due.value);
  });

  async function run(id: string) {
    running.value = true;
    try {
      const fact = store.album.peek().get(id) as Fact;
      const moment = momentOf(fact);
      const faces = facesOf(fact);
      const moved = moment && (await engine.watchLips(moment, faces).catch(() => null));
      if (moved) know(id, new Map(faces.map((face, i) => [face, moved[i]])));
    } finally {
      seen.value = new Set([...seen.peek(), id]);
      running.value = false;
    }
  }

  /** Stores the faces of a frame, and places its text again. */
  function know(id: string, moved: ReadonlyMap<Detection, Detection>) {
    const fact = store.album.peek().get(id);
    if (!fact?.meta) return;
    const subjects = fact.meta.subjects.map((subject) => moved.get(subject) ?? subject);
    store.know({ ...fact, meta: { ...fact.meta, subjects } });
    const pages = sheetsOf(store.project.peek()).flatMap(({ page }, at) => {
      const { words = [] } = page;
      if (!words.some((word) => speaks(word) && word.photo === id)) return [];
      const free = words.flatMap(({ auto }, i) => (auto === false ? [] : [i]));
      const placed = settled(page, free);
      return JSON.stringify(placed.words) === JSON.stringify(words) ? [] : [{ at, page: placed }];
    });
    if (pages.length > 0) setWords(store, pages, { silent: true });
  }

  function momentOf({ video, time }: Fact) {
    const film = video === undefined ? undefined : store.videos.value.get(video);
    if (!film || film.duration === null || time === undefined) return null;
    return { file: film.file, time, duration: film.duration };
  }
}

/** Whether a text item is an automatic balloon of a subtitle. */
function speaks({ kind, auto, cue }: Word): boolean {
  return kind === 'balloon' && auto !== false && cue !== undefined;
}

/** The faces of a photo with known lips. */
function facesOf({ meta }: Fact): readonly Detection[] {
  return (meta?.subjects ?? []).filter(({ label, expression }) => label === 'face' && expression !== undefined);
}
