// @ts-check
/**
 * Photos that a page names and nobody has: an empty frame keeps the place of each. Files that are added are held against
 * them first, and one that is such a photo takes the place of its frame wherever that stands, in every state of the undo.
 * A message tells of them as long as there are any, and how many are left.
 */

import { computed, effect, untracked } from '@preact/signals';
import { Priority } from '../../engine/queue.js';
import { isVideo } from '../../engine/video.js';
import { strings } from '../../strings.js';
import { hashOf, looksLike } from './identity.js';
import { absentOf } from './placeholder.js';
import { renamed } from './project-json.js';

/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Absent} Absent */
/** @typedef {{ frame: Fact, id: string, name: string, meta: import('../../engine/protocol.js').Imported['meta'] }} Match */
/** @typedef {ReturnType<typeof createAbsentPhotos>} AbsentPhotos */

/** Milliseconds in which who opened the project can say more than that photos are missing. */
const MORE_TO_SAY = 300;

/**
 * @param {{
 *   store: import('../store.js').Store, engine: Pick<import('../../engine/engine.js').Engine, 'importPhoto' | 'forgetPhoto'>,
 *   reading: Pick<import('../reading.js').Reading, 'freshIds' | 'count'>, messages: Pick<import('../messages.js').Messages, 'note' | 'grave' | 'change' | 'close'>,
 *   chooseFiles: () => void, missing?: import('@preact/signals').ReadonlySignal<readonly Fact[]>,
 * }} app `missing`: photos that are on the page, but can be saved no more
 */
export function createAbsentPhotos({ store, engine, reading, messages, chooseFiles, missing }) {
  const empty = computed(() => store.facts.value.filter(({ absent }) => absent));
  const list = computed(() => [
    ...empty.value,
    ...(missing?.value ?? []).flatMap((fact) => (store.album.value.has(fact.id) ? { ...fact, absent: absentOf(fact) } : [])),
  ]);

  const way = { label: strings.choosePhotos, run: chooseFiles };
  /**
   * What was told: the message, of which frames, and how many they were.
   * @type {{ id: number, frames: ReadonlySet<string>, count: number, more?: import('../messages.js').Way } | null}
   */
  let told = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let telling;

  effect(() => {
    const frames = empty.value.map(({ id }) => id);
    untracked(() => follow(frames));
  });

  return { list, fill, tell };

  /** Keeps the message true. @param {readonly string[]} frames that are empty now */
  function follow(frames) {
    clearTimeout(telling);
    const { id = 0, count = 0 } = told ?? {};
    // Those of another project are another message.
    if (!frames.some((frame) => told?.frames.has(frame))) {
      messages.close(id);
      told = null;
      if (frames.length > 0) telling = setTimeout(() => tell(strings.photosStillMissing(frames.length)), MORE_TO_SAY);
    } else if (told && frames.length !== count) {
      told = { ...told, count: frames.length };
      messages.change(id, strings.photosStillMissing(frames.length), way, told.more);
    }
  }

  /**
   * Tells that photos of the project on the page are missing.
   * @param {string} text
   * @param {import('../messages.js').Way} [more] another way than to choose them
   */
  function tell(text, more) {
    clearTimeout(telling);
    messages.close(told?.id ?? 0);
    const frames = empty.peek().map(({ id }) => id);
    told = frames.length > 0 ? { id: messages.grave(text, way, more), frames: new Set(frames), count: frames.length, more } : null;
  }

  /**
   * @param {readonly File[]} files
   * @returns {Promise<File[]>} those that no frame waits for
   */
  async function fill(files) {
    const frames = [...list.peek()];
    if (frames.length === 0 || files.length === 0) return [...files];
    reading.count(0, files.length);
    /** @type {Map<File, Match>} */
    const matches = new Map();
    const free = () => frames.filter((frame) => ![...matches.values()].some((match) => match.frame === frame));
    try {
      const hashes = new Map();
      for (const file of files) if (!isVideo(file)) hashes.set(file, await hashOf(file));
      // A photo that is the very one comes before one that looks like it.
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
      messages.note(strings.photosBack(matches.size));
      const left = empty.peek().length;
      // Whoever closed the message is busy with them again.
      if (left > 0 && !messages.change(told?.id ?? 0, strings.photosStillMissing(left), way, told?.more)) tell(strings.photosStillMissing(left));
    }
    return files.filter((file) => !matches.has(file));

    /** @param {File} file @param {Fact} [known] the frame that waits for it, where its bytes say so */
    async function tried(file, known) {
      const [id] = reading.freshIds(1);
      // What cannot be read is named where it is added as a photo.
      const meta = await engine.importPhoto(id, file, { priority: Priority.PAGE }).catch(() => null);
      const frame = meta && (known ?? free().find(({ absent }) => absent && looksLike(meta, absent)) ??
        free().find(({ name, absent }) => absent?.fingerprint === '' && name === file.name));
      if (frame) matches.set(file, { frame, id, name: file.name, meta });
      else if (meta) engine.forgetPhoto(id);
    }
  }

  /** @param {readonly Match[]} matches */
  function put(matches) {
    const album = new Map(store.album.peek());
    const names = new Map(matches.map(({ frame, id }) => [frame.id, id]));
    for (const { frame, id, name, meta } of matches) {
      const { subjects, measured } = /** @type {Absent} */ (frame.absent);
      album.delete(frame.id);
      // Its place in time is the one that it had among the others of its page.
      const taken = frame.meta?.taken ?? meta.taken;
      const known = { meta: { ...meta, taken, subjects: subjects ?? [] }, measures: measured ? meta.measures : null, looked: subjects !== null };
      album.set(id, { id, name, credit: frame.credit, ...known });
    }
    store.load({ history: renamed(store.history.peek(), names), album, videos: store.videos.peek() });
    for (const { frame } of matches) engine.forgetPhoto(frame.id);
  }
}
