/**
 * Shared code for opening files: one at a time, with progress. A file is read and checked completely before anything in
 * the app changes. It becomes a separate project.
 */

import { signal } from '@preact/signals';
import { PHOTOS_AT_ONCE, SILENCE } from '../../engine/limits.ts';
import { timeLimit } from '../../engine/scheduler.ts';
import { cancelled as stopped, failure } from '../../engine/protocol.ts';
import { Priority } from '../../engine/queue.ts';
import { strings } from '../../strings/strings.ts';
import { codeOf, explain } from '../../ui/explain.ts';
import { reportFailure } from '../../ui/importing.ts';
import { freshPlace } from '../../document/place.ts';
import { takenBy } from './project-json.ts';
import { UNLIKE, placeholderOf } from '../../photos/placeholder.ts';
import { damaged } from '../../engine/protocol.ts';
import type { Messages, Way } from '../../ui/messages.ts';
import type { Fact } from '../../document/album.ts';
import type { Planner } from '../../document/store.ts';
import type { Engine } from '../../engine/engine.ts';
import type { Watch } from '../../engine/inflate.ts';
import type { Imported } from '../../engine/protocol.ts';
import type { Opening } from '../opening.ts';
import type { Content } from '../restoring.ts';
import type { readArchive } from '../../engine/archive.ts';
import type { FilePhoto } from './project-json.ts';
import type { Signal } from '@preact/signals';

export type Archive = Awaited<ReturnType<typeof readArchive>>;
export type FileOpening = ReturnType<typeof createFileOpening>;

/** Reads a photo into the engine. It is freed if opening fails. */
type Take = (id: string, blob: Blob) => Promise<Imported['meta']>;
/** A photo that could not be read. */
type Failed = { name: string; why: string };
/** `watch` receives all incoming data, so that a file without data times out. */
export type Hands = {
  planner: Planner;
  photos: (wanted: readonly FilePhoto[], archive: Archive) => Promise<Fact[]>;
  absent: (photo: FilePhoto, number: number) => Promise<Fact>;
  watch: Required<Watch>;
};

export function createFileOpening({
  engine,
  messages,
  opening,
}: {
  engine: Pick<Engine, 'ready' | 'importPhoto' | 'forgetPhoto'>;
  messages: Pick<Messages, 'fileFailed' | 'alert'>;
  opening: Pick<Opening, 'enter'>;
}) {
  /** Progress of the current file. */
  const progress: Signal<{ name: string; done: number; total: number } | null> = signal(null);
  let stop: AbortController | null = null;
  /** The last file in the queue. */
  let last: Promise<unknown> = Promise.resolve();
  /** Number of cancellations. */
  let stops = 0;

  return { progress, open, unpack, cancel, stops: () => stops };

  /** Cancels the current file and the queue. */
  function cancel() {
    stops += 1;
    stop?.abort(stopped());
  }

  /**
   * @param way another action for a file that cannot be opened
   * @returns whether it is on the page now
   */
  function open(file: File, read: (hands: Hands) => Promise<Content>, way?: Way): Promise<boolean> {
    const before = stops;
    const done = last.then(() => stops === before && openNow(file, read, way));
    last = done.catch(() => {});
    return done;
  }

  /**
   * Reads a file that is not a project, in the same queue, with progress.
   * @param look `step` reports progress
   * @returns null if it was cancelled or cannot be read, after an error message
   */
  function unpack<T>(
    file: File,
    look: (watch: Hands['watch'], step: (done: number, total: number) => void) => Promise<T>,
  ): Promise<T | null> {
    const before = stops;
    const done = last.then(() => (stops === before ? unpackNow(file, look) : null));
    last = done.catch(() => {});
    return done;
  }

  async function unpackNow<T>(
    file: File,
    look: (watch: Hands['watch'], step: (done: number, total: number) => void) => Promise<T>,
  ): Promise<T | null> {
    stop = new AbortController();
    progress.value = { name: file.name, done: 0, total: 1 };
    const { signal: cancelled } = stop;
    const quiet = silence(stop);
    try {
      const step = (done: number, total: number) => {
        if (!cancelled.aborted) progress.value = { name: file.name, done, total };
      };
      const found = await Promise.race([quiet.over, look({ signal: cancelled, beat: quiet.beat }, step)]);
      cancelled.throwIfAborted();
      return found;
    } catch (error) {
      tell(file, cancelled.aborted ? cancelled.reason : error);
      return null;
    } finally {
      quiet.end();
      progress.value = null;
    }
  }

  function tell(file: File, error: unknown, way?: Way) {
    const text = (why: string) => strings.projectFileNotOpened({ name: file.name, why });
    reportFailure(messages, file.name, error, { reasons: strings.projectReasons, text, way });
  }

  async function openNow(file: File, read: (hands: Hands) => Promise<Content>, way?: Way) {
    stop = new AbortController();
    progress.value = { name: file.name, done: 0, total: 1 };
    /** Photos that are in the engine. */
    const taken: string[] = [];
    /** The others, which are named when the rest is open. */
    const failed: Failed[] = [];
    const { signal: cancelled } = stop;
    const quiet = silence(stop);
    const watch = { signal: cancelled, beat: quiet.beat };
    const take: Take = async (id, blob) => {
      const meta = await engine.importPhoto(id, blob, { priority: Priority.PAGE, signal: cancelled });
      quiet.beat();
      taken.push(id);
      return meta;
    };
    try {
      const planner = await engine.ready;
      quiet.beat();
      const content = await Promise.race([
        quiet.over,
        read({
          planner,
          watch,
          photos: (wanted, archive) => readPhotos(wanted, archive, { take, watch, failed }),
          absent: (photo, number) => placeFor(photo, number, take),
        }),
      ]);
      cancelled.throwIfAborted();
      await opening.enter(freshPlace(), content, undefined, { join: true });
      if (content.dropped?.length) messages.alert(strings.partsLeftOut({ name: file.name, n: content.dropped.length }));
      for (const { name, why } of failed) messages.fileFailed(name, why);
      return true;
    } catch (error) {
      taken.forEach(engine.forgetPhoto);
      // After a cancellation all errors have the same reason.
      tell(file, cancelled.aborted ? cancelled.reason : error, way);
      return false;
    } finally {
      quiet.end();
      progress.value = null;
    }
  }

  /** @returns readable photos; `failed` lists the others */
  async function readPhotos(
    photos: readonly FilePhoto[],
    archive: Archive,
    { take, watch, failed }: { take: Take; watch: Hands['watch']; failed: Failed[] },
  ): Promise<Fact[]> {
    // Thousands that are one file would be read thousands of times.
    if (new Set(photos.map(({ path }) => path)).size < photos.length) throw damaged('photos: two of them are one file');
    const packed = photos.some(({ path }) => archive.get(path)?.packed);
    // Compressed files are completely in memory while they are read.
    const facts = await inTurns(photos, packed ? 1 : PHOTOS_AT_ONCE, async (photo) => {
      const { path, type, subjects, mask, measured, rank: _rank, like, absent, ...fact } = photo;
      try {
        const found = archive.get(path);
        if (!found) throw damaged(`${path} is missing`);
        const meta = await take(fact.id, new File([await found.read(watch)], fact.name, { type }));
        const facts = { taken: takenBy(photo, meta.taken), subjects: subjects ?? [], ...(mask && { mask }) };
        const known = { ...fact, meta: { ...meta, ...facts } };
        if (absent && like) return keepsPlace(known, photo);
        return { ...known, measures: measured ? meta.measures : null, looked: subjects !== null };
      } catch (error) {
        if (watch.signal.aborted || ['cancelled', 'too-large-project'].includes(codeOf(error))) throw error;
        failed.push({ name: fact.name, why: explain(error) });
        return [];
      } finally {
        const now = progress.peek();
        if (now && !watch.signal.aborted) progress.value = { ...now, done: now.done + 1, total: photos.length };
      }
    });
    return facts.flat();
  }
}

/**
 * @param work no further item starts after an error
 * @returns in the order of the list
 */
async function inTurns<T, R>(list: readonly T[], atOnce: number, work: (item: T) => Promise<R>): Promise<R[]> {
  const done: R[] = Array(list.length);
  let next = 0;
  const runner = async () => {
    while (next < list.length) {
      const at = next;
      next += 1;
      done[at] = await work(list[at]).catch((error) => {
        next = list.length;
        throw error;
      });
    }
  };
  await Promise.all(Array.from({ length: atOnce }, runner));
  return done;
}

/**
 * Times out after a minute without data.
 * @returns `beat`: resets the timer; `over` rejects after a timeout or cancellation
 */
function silence(stop: AbortController): { beat: () => void; over: Promise<never>; end: () => void } {
  let relax = () => {};
  let since = -Infinity;
  const beat = () => {
    // There are thousands of pieces, so the timer is not restarted for each.
    if (performance.now() - since < SILENCE / 60) return;
    since = performance.now();
    relax();
    relax = timeLimit(SILENCE, () => stop.abort(failure('silent-project', 'Nothing of it came for a minute.')));
  };
  const over: Promise<never> = new Promise((_, reject) => {
    stop.signal.addEventListener('abort', () => reject(stop.signal.reason), { once: true });
  });
  // Ignore it after success.
  over.catch(() => {});
  return {
    beat,
    over,
    end: () => {
      relax();
      since = Infinity;
    },
  };
}

/**
 * An empty frame for a missing photo.
 * @param number from 1
 */
async function placeFor(photo: FilePhoto, number: number, take: Take): Promise<Fact> {
  const { id, credit, like } = photo;
  const name = strings.absentPhoto({ n: number });
  const meta = await take(id, new File([await placeholderOf(like ?? UNLIKE)], name, { type: 'image/png' }));
  return keepsPlace(
    { id, name, credit, meta: { ...meta, taken: takenBy(photo, null) } },
    { ...photo, like: like ?? UNLIKE },
  );
}

/**
 * @param fact of the empty frame
 * @returns whether it gets the same crop, without a comparison
 */
function keepsPlace(
  fact: Omit<Fact, 'meta' | 'measures'> & { meta: NonNullable<Fact['meta']> },
  { like, subjects, measured }: FilePhoto,
): Fact {
  const { width, height, ...rest } = like ?? UNLIKE;
  const meta = { ...fact.meta, width, height, subjects: subjects ?? [] };
  return { ...fact, meta, measures: null, looked: true, absent: { width, height, ...rest, subjects, measured } };
}
