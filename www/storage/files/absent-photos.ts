/**
 * Missing photos: a page shows them, but no project has their files. An empty frame represents each. Added files are
 * compared with them first. A matching file replaces its frame in every undo state. A message shows the number of
 * missing photos.
 */

import { computed, effect, untracked } from '@preact/signals';
import { Priority } from '../../engine/queue.ts';
import { isVideo } from '../../engine/video.ts';
import { strings } from '../../strings/strings.ts';
import { hashOf, looksLike } from '../../photos/identity.ts';
import { absentOf } from '../../photos/placeholder.ts';
import { renamed } from './project-json.ts';
import { encoded, recordIn } from '../../engine/interned.ts';
import { openEditing } from '../../document/editing.ts';
import { createTimer } from '../../engine/scheduler.ts';
import type { Messages, Way } from '../../ui/messages.ts';
import type { Absent, Fact } from '../../document/album.ts';
import type { Store } from '../../document/store.ts';
import type { Engine } from '../../engine/engine.ts';
import type { Imported } from '../../engine/protocol.ts';
import type { Reading } from '../../photos/reading.ts';
import type { ReadonlySignal } from '@preact/signals';

type Match = { frame: Fact; id: string; name: string; meta: Imported['meta'] };
export type AbsentPhotos = ReturnType<typeof createAbsentPhotos>;

/** Milliseconds to wait for a better message than a list of missing photos, from the code that opened the project. */
const MORE_TO_SAY = 300;

/** @param app `missing`: photos on the page that cannot be saved any more */
export function createAbsentPhotos({
  store,
  engine,
  reading,
  messages,
  chooseFiles,
  missing,
}: {
  store: Store;
  engine: Pick<Engine, 'importPhoto' | 'forgetPhoto'>;
  reading: Pick<Reading, 'freshIds' | 'count'>;
  messages: Pick<Messages, 'note' | 'grave' | 'change' | 'close'>;
  chooseFiles: () => void;
  missing?: ReadonlySignal<readonly Fact[]>;
}) {
  const empty = computed(() => store.facts.value.filter(({ absent }) => absent));
  const list = computed(() => [
    ...empty.value,
    ...(missing?.value ?? []).flatMap((fact) =>
      store.album.value.has(fact.id) ? { ...fact, absent: absentOf(fact) } : [],
    ),
  ]);

  const way = { label: strings.choosePhotos, run: chooseFiles };
  /** The current message, its frames and their number. */
  let told: { id: number; frames: ReadonlySet<string>; count: number; more?: Way } | null = null;
  const telling = createTimer();

  effect(() => {
    const frames = empty.value.map(({ id }) => id);
    untracked(() => follow(frames));
  });

  return { list, fill, tell };

  /**
   * Keeps the message true.
   * @param frames that are empty now
   */
  function follow(frames: readonly string[]) {
    telling.stop();
    const { id = 0, count = 0 } = told ?? {};
    // Another project shows a new message.
    if (!frames.some((frame) => told?.frames.has(frame))) {
      messages.close(id);
      told = null;
      if (frames.length > 0) telling.start(MORE_TO_SAY, () => tell(strings.photosStillMissing({ n: frames.length })));
    } else if (told && frames.length !== count) {
      told = { ...told, count: frames.length };
      messages.change(id, strings.photosStillMissing({ n: frames.length }), way, told.more);
    }
  }

  /**
   * Tells that photos of the project on the page are missing.
   * @param more another way than to choose them
   */
  function tell(text: string, more?: Way) {
    telling.stop();
    messages.close(told?.id ?? 0);
    const frames = empty.peek().map(({ id }) => id);
    told =
      frames.length > 0
        ? { id: messages.grave(text, way, more), frames: new Set(frames), count: frames.length, more }
        : null;
  }

  /** @returns files that match no frame */
  async function fill(files: readonly File[]): Promise<File[]> {
    const frames = [...list.peek()];
    if (frames.length === 0 || files.length === 0) return [...files];
    reading.count(0, files.length);
    const matches: Map<File, Match> = new Map();
    const free = () => frames.filter((frame) => ![...matches.values()].some((match) => match.frame === frame));
    try {
      const hashes = new Map();
      for (const file of files) if (!isVideo(file)) hashes.set(file, await hashOf(file));
      // An identical photo is preferred to a similar one.
      for (const exact of [true, false]) {
        for (const [file, hash] of hashes) {
          if (matches.has(file) || free().length === 0) continue;
          const known = exact ? free().find(({ absent }) => hash !== '' && absent?.hash === hash) : undefined;
          if (exact && !known) continue;
          await tried(file, known);
        }
      }
    } finally {
      reading.count(files.length, 0);
    }
    if (matches.size > 0) {
      put([...matches.values()]);
      messages.note(strings.photosBack({ n: matches.size }));
      const left = empty.peek().length;
      // If the user closed the message, show it again.
      if (left > 0 && !messages.change(told?.id ?? 0, strings.photosStillMissing({ n: left }), way, told?.more))
        tell(strings.photosStillMissing({ n: left }));
    }
    return files.filter((file) => !matches.has(file));

    /** @param known the matching frame, if the hash is equal */
    async function tried(file: File, known?: Fact) {
      const [id] = reading.freshIds(1);
      // Unreadable files are reported when they are added as photos.
      const meta = await engine.importPhoto(id, file, { priority: Priority.PAGE }).catch(() => null);
      const frame =
        meta &&
        (known ??
          free().find(({ absent }) => absent && looksLike(meta, absent)) ??
          free().find(({ name, absent }) => absent?.fingerprint === '' && name === file.name));
      if (frame) matches.set(file, { frame, id, name: file.name, meta });
      else if (meta) engine.forgetPhoto(id);
    }
  }

  function put(matches: readonly Match[]) {
    const album = new Map(store.album.peek());
    const names = new Map(matches.map(({ frame, id }) => [frame.id, id]));
    for (const { frame, id, name, meta } of matches) {
      const { subjects, measured } = frame.absent as Absent;
      album.delete(frame.id);
      // Its capture time is the time in its page's data.
      const taken = frame.meta?.taken ?? meta.taken;
      const known = {
        meta: { ...meta, taken, subjects: subjects ?? [] },
        measures: measured ? meta.measures : null,
        looked: subjects !== null,
      };
      album.set(id, { id, name, credit: frame.credit, ...known });
    }
    const [planner, editing] = [store.planner.peek(), store.editing()];
    if (!planner || !editing) return;
    const record = renamed(recordIn(editing.save().bytes), names);
    store.load({
      editing: openEditing(planner.createEditor(), encoded(record)),
      album,
      videos: store.videos.peek(),
    });
    for (const { frame } of matches) engine.forgetPhoto(frame.id);
  }
}
