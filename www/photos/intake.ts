/** Imports files: each becomes a photo of the album with its measurements, or an error message. Both are counted. */

import { batch } from '@preact/signals';
import { CROWD, Priority } from '../engine/queue.ts';
import { freshId } from '../document/fresh-id.ts';
import { strings } from '../strings/strings.ts';
import { otherKind } from '../engine/file-kinds.ts';
import { codeOf } from '../ui/explain.ts';
import { reportFailure } from '../ui/importing.ts';
import { reasonOfKind } from '../ui/reason-of-kind.ts';
import { looksLike } from './identity.ts';
import { emptyFrames } from './placeholder.ts';
import { createTimer, nextTask } from '../engine/scheduler.ts';
import { UserError } from '../ui/user-error.ts';
import type { Messages } from '../ui/messages.ts';
import type { Fact } from '../document/album.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Imported } from '../engine/protocol.ts';
import type { Damage } from '../engine/types.ts';

export type Intake = ReturnType<typeof createIntake>;

/** Interval in milliseconds for updates of many photos, so that dependent views are not updated for each photo. */
const TOGETHER = 300;
/** Codes of files that may not be photos. Raw photos begin like TIFF files. */
const NO_PHOTO = ['unknown-format', 'unsupported', 'damaged'];

/** @returns a unique prefix of photo ids for this session */
export function freshPhotoPrefix(): string {
  return `p${freshId(6)}-`;
}

/** @param app `prefix` begins the ids of photos */
export function createIntake({
  store,
  pages,
  engine,
  messages,
  prefix = 'p',
}: {
  store: Store;
  pages: Pick<Pages, 'refine' | 'refit'>;
  engine: Pick<Engine, 'importPhoto' | 'importDraft' | 'forgetPhoto'>;
  messages: Pick<Messages, 'fileFailed'>;
  prefix?: string;
}) {
  let lastId = 0;
  let untold: (() => void)[] = [];
  const timer = createTimer();

  return { freshIds, isShown, readPhoto, arrived, failed, leaveOut, count };

  function freshIds(many: number): string[] {
    return Array.from({ length: many }, () => `${prefix}${(lastId += 1)}`);
  }

  /** Whether a photo is on the visible page. */
  function isShown(id: string): boolean {
    return !!store.page.peek()?.panels.some((panel) => panel.photo === id);
  }

  async function readPhoto(id: string, file: File, signal: AbortSignal) {
    store.originals.set(id, file);
    const draft =
      store.sketch.peek() && isShown(id) ? engine.importDraft(id, file, { priority: Priority.PAGE, signal }) : null;
    const drafted = draft !== null && (await showDraft(id, draft));
    let isCounted = true;
    // A photo on the page is read even if the user cancels.
    const call = drafted
      ? { priority: Priority.VIEW }
      : { priority: isShown(id) ? Priority.PAGE : Priority.REST, signal };
    let read = await engine.importPhoto(id, file, call).then(
      (meta) => ({ meta }),
      async (error) => ({ error: await explained(file, error) }),
    );
    if ('error' in read && drafted) forgetDraft(id);
    if ('error' in read && store.album.peek().get(id)?.meta) {
      failed(file, read.error);
      read = await emptyFrame(id).then(
        (meta) => ({ meta }),
        (error) => ({ error }),
      );
    }
    await together(isShown(id), () => {
      try {
        if ('error' in read) throw read.error;
        arrived(id, read.meta, { drafted });
      } catch (error) {
        failed(file, error);
      }
      store.originals.delete(id);
      leaveOut([id]);
      if (drafted && 'error' in read && !store.sketch.peek()) pages.refit({ grow: false, silent: true });
      isCounted = !drafted && !isLast();
      if (isCounted) count(1, 0);
    });
    if (isCounted) return;
    // The next step is as much work as drawing the last photo, so it is a separate task. The page begins to replace a
    // draft before.
    await nextTask();
    count(1, 0);
  }

  /**
   * Notes a smaller copy of a photo, so that the first page appears earlier.
   * @returns whether there is one
   */
  async function showDraft(id: string, draft: Promise<Imported['meta'] | null>): Promise<boolean> {
    const meta = await draft;
    return meta !== null && arrived(id, meta);
  }

  /** Forgets a draft whose photo cannot be read. */
  function forgetDraft(id: string) {
    const fact = store.album.peek().get(id);
    if (fact) store.know({ ...fact, meta: null, measures: null });
    engine.forgetPhoto(id);
  }

  /** Replaces a photo that can no longer be read by an empty frame, which keeps its place. */
  async function emptyFrame(id: string) {
    const [{ fact, file }] = await emptyFrames([store.album.peek().get(id) as Fact]);
    const meta = await engine.importPhoto(id, file, { priority: isShown(id) ? Priority.PAGE : Priority.REST });
    // Another project may be open now, without this photo.
    if (store.album.peek().has(id)) store.know(fact);
    return meta;
  }

  /** Whether a photo is the last of many. */
  function isLast() {
    const { done, total } = progress();
    return total > CROWD && total - done === 1;
  }

  /**
   * @param now whether to update immediately
   * @returns resolves after the update
   */
  function together(now: boolean, tell: () => void): Promise<void> {
    const { done, total } = progress();
    return new Promise((resolve) => {
      untold.push(() => {
        tell();
        resolve();
      });
      if (now || total - done <= CROWD) tellAll();
      else if (!timer.runs) timer.start(TOGETHER, tellAll);
    });
  }

  function tellAll() {
    timer.stop();
    const all = untold;
    untold = [];
    batch(() => all.forEach((tell) => tell()));
  }

  /**
   * Notes a photo that was read.
   * @param how `more` facts; `drafted`: whether the photo replaces its draft
   * @returns whether the album has it
   */
  function arrived(
    id: string,
    { damage, ...meta }: Imported['meta'],
    { more, drafted = false }: { more?: Partial<Fact>; drafted?: boolean } = {},
  ): boolean {
    const fact = store.album.peek().get(id);
    // A frame of a video that is no longer wanted, or a photo of a project that was closed.
    if (!fact) {
      engine.forgetPhoto(id);
      return false;
    }
    // The person knows of a photo that is read again.
    if (damage && (drafted || !fact.meta)) reportDamage(fact.name, damage);
    store.know({ ...fact, ...(drafted ? replacing(fact, meta) : knownOf(fact, meta)), ...more });
    if (isShown(id) && !store.sketch.peek()) pages.refine();
    return true;
  }

  function reportDamage(name: string, { missing, coarse }: Damage) {
    const share = strings.percent(Math.max(0.01, missing || coarse));
    const text = missing > 0 ? strings.photoDamaged({ name, share }) : strings.photoCoarse({ name, share });
    messages.fileFailed(name, text, { text, isUsed: true });
  }

  /** Replaces the measurements of a draft. Its faces stay until detection finds them in the photo. */
  function replacing({ meta: draft }: Fact, meta: Omit<Imported['meta'], 'damage'>): Partial<Fact> {
    const found = draft?.subjects.filter(({ label }) => label !== 'lettering') ?? [];
    return { meta: { ...meta, subjects: [...found, ...meta.subjects] }, measures: meta.measures };
  }

  function knownOf({ meta: before, absent }: Fact, meta: Omit<Imported['meta'], 'damage'>): Partial<Fact> {
    if (absent) {
      const { width, height, subjects, measured } = absent;
      // The missing photo was found. Otherwise its frame stays, and matches no other file.
      if (looksLike(meta, absent))
        return {
          meta: { ...meta, subjects: subjects ?? [] },
          measures: measured ? meta.measures : null,
          looked: subjects !== null,
          absent: undefined,
        };
      return {
        meta: { ...meta, width, height, taken: before?.taken ?? null, subjects: subjects ?? [] },
        measures: null,
      };
    }
    // A photo that is read again retains its detection results.
    return before ? { meta: { ...meta, subjects: before.subjects } } : { meta, measures: meta.measures };
  }

  function failed(file: File, error: unknown) {
    reportFailure(messages, file.name, error);
  }

  /** @returns the error, or the kind of the file as the reason, if it is not a photo */
  async function explained(file: File, error: unknown): Promise<unknown> {
    const kind = NO_PHOTO.includes(codeOf(error)) ? await otherKind(file) : undefined;
    const reason = kind ? reasonOfKind(kind) : '';
    return reason === '' ? error : new UserError(reason);
  }

  /**
   * Removes the photos that could not be read.
   * @returns the others
   */
  function leaveOut(ids: readonly string[]): string[] {
    const missing = ids.filter((id) => !store.album.peek().get(id)?.meta);
    if (missing.length > 0)
      batch(() => {
        store.change({ type: 'forget-photos', ids: missing });
        // Nothing speaks of them any more; saved, they would be looked for at every visit.
        store.unknow(missing);
      });
    return ids.filter((id) => !missing.includes(id));
  }

  function progress() {
    return store.reading.peek() ?? { done: 0, total: 0 };
  }

  function count(done: number, more: number) {
    const before = progress();
    const now = { done: before.done + done, total: before.total + more };
    store.reading.value = now.done < now.total ? now : null;
  }
}
