/**
 * A style from a picture: the picture, the search on a photo of the user, and the proposed styles. They belong to the
 * session; one that is saved, used or edited becomes a part of the project.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { codeOf, explain } from '../ui/explain.ts';
import type { Signal } from '@preact/signals';
import type { Ui } from '../ui/ui.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Style } from '../engine/types.ts';
import type { Messages } from '../ui/messages.ts';

export type Imitation = ReturnType<typeof createImitation>;
type Picture = { name: string; file: Blob };

/** Prefix of picture ids in the engine, which differ from photo ids. */
const ID = 'imitated-picture';

export function createImitation({
  store,
  engine,
  messages,
  ui,
  seed,
  freshId,
}: {
  store: Pick<Store, 'tray'>;
  engine: Pick<Engine, 'importPhoto' | 'forgetPhoto' | 'readLook' | 'surveyLooks' | 'imitate'>;
  messages: Pick<Messages, 'alert'>;
  ui: Pick<Ui, 'work'>;
  seed: () => number;
  freshId: () => string;
}) {
  const picture: Signal<Picture | null> = signal(null);
  /** Progress of the search, 0 to 1; null without a search. */
  const progress: Signal<number | null> = signal(null);
  const proposals: Signal<readonly Style[]> = signal([]);
  /** Error of the search, as a sentence. */
  const fault: Signal<string | null> = signal(null);
  /** Whether the picture was rejected for a reason that the user may override. */
  const doubted = signal(false);
  /** The proposal that is seen large. */
  const shown: Signal<string | null> = signal(null);
  /** The photo that was chosen to try styles on. */
  const photo: Signal<string | null> = signal(null);
  let running: AbortController | null = null;
  let pictures = 0;
  /** The measured look of the picture. */
  let look: string | null = null;
  let anyway = false;

  return {
    picture,
    progress,
    proposals,
    fault,
    doubted,
    insist,
    shown,
    photo,
    open,
    prepare,
    take,
    search,
    stop,
    choose,
    clear,
  };

  /** Shows the workspace in its last state. */
  function open() {
    if (store.tray.peek().length === 0) messages.alert(strings.imitationNeedsPhotos);
    else ui.work.value = 'imitation';
  }

  /**
   * Runs the survey of a photo in advance, which makes the search faster.
   * @returns ends it
   */
  function prepare(id: string): () => void {
    const ends = new AbortController();
    // Errors are ignored here. A search would have the same error and report it.
    void engine.surveyLooks(id, { signal: ends.signal }).catch(() => undefined);
    return () => ends.abort();
  }

  /** Takes the first of some files as the picture. */
  function take(files: readonly File[]) {
    const [file] = files;
    if (!file) return;
    if (store.tray.peek().length === 0) {
      messages.alert(strings.imitationNeedsPhotos);
      return;
    }
    stop();
    look = null;
    anyway = false;
    doubted.value = false;
    picture.value = { name: file.name, file };
    proposals.value = [];
    fault.value = null;
    shown.value = null;
    ui.work.value = 'imitation';
  }

  /** Searches styles for a photo, and reads the picture first if necessary. */
  async function search(id: string) {
    const wanted = picture.peek();
    if (!wanted) return;
    stop();
    const mine = new AbortController();
    running = mine;
    const { signal: ends } = mine;
    fault.value = null;
    doubted.value = false;
    progress.value = 0;
    try {
      look ??= await read(wanted, ends);
      const found = await engine.imitate(look, id, {
        seed: seed() >>> 0,
        signal: ends,
        onProgress: (done) => {
          if (!ends.aborted) progress.value = done;
        },
      });
      if (ends.aborted) return;
      proposals.value = found.map((style, i) => named(style, wanted.name, i + 1));
      shown.value = proposals.value[0]?.id ?? null;
      if (found.length === 0) fault.value = strings.imitationNone;
    } catch (error) {
      const code = codeOf(error);
      if (!ends.aborted && code !== 'cancelled') {
        fault.value = explain(error, { reasons: strings.imitationReasons });
        doubted.value = code === 'plain-photo';
      }
    }
    if (running === mine) {
      running = null;
      progress.value = null;
    }
  }

  async function read({ file }: Picture, ends: AbortSignal): Promise<string> {
    // A worker may still have the pixels of the previous picture.
    const id = `${ID}-${(pictures += 1)}`;
    try {
      await engine.importPhoto(id, file, { signal: ends });
      return await engine.readLook(id, { anyway, signal: ends });
    } finally {
      engine.forgetPhoto(id);
    }
  }

  /** Searches even if the picture seems to be a plain photo. */
  function insist(id: string) {
    anyway = true;
    void search(id);
  }

  /** Gives a style a name and a unique id. The score applies to only this search. */
  function named({ score: _, ...style }: Style, file: string, place: number): Style {
    return {
      ...style,
      id: freshId(),
      name: strings.imitationName({ picture: file.replace(/\.[^.]*$/, '').slice(0, 40), place }),
    };
  }

  /** @param id of a proposal */
  function choose(id: string) {
    shown.value = id;
  }

  function stop() {
    running?.abort();
    running = null;
    progress.value = null;
  }

  /** Forgets all of it. */
  function clear() {
    stop();
    look = null;
    doubted.value = false;
    picture.value = null;
    proposals.value = [];
    fault.value = null;
    shown.value = null;
    photo.value = null;
  }
}
