/**
 * Words as pages are planned: the letters, loaded when a page first has words, and the places of those that nobody has
 * moved.
 */

import { computed, effect, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { Lettering as Letters } from '../engine/words.ts';
import type { Signal } from '@preact/signals';

/** Words are shown among the alternatives once a drag rests for this long, in ms. */
const REST = 300;

/** @param app `load`: what knows the letters */
export function createWordPlanning({
  store,
  messages,
  load,
}: {
  store: Store;
  messages: Pick<Messages, 'alert'>;
  load: () => Promise<Letters>;
}) {
  const letters: Signal<Letters | null> = signal(null);
  const none = [] as readonly Word[];
  const words = computed(() => store.page.value?.words ?? none);
  /** The words as they were when they last rested. */
  const rested = signal(none);

  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const now = words.value;
    clearTimeout(timer);
    if (essence(now) !== essence(rested.peek()))
      timer = setTimeout(() => {
        rested.value = now;
      }, REST);
  });
  // A page that comes with words, from a file or a session before, needs the letters too.
  effect(() => {
    if (words.value.length > 0 && !letters.value) void ready().then((table) => table && settle(true));
  });

  return { words, letters, rested, ready, settled, on };

  /** @returns null where they cannot be had, which is said */
  async function ready(): Promise<Letters | null> {
    try {
      letters.value ??= await load();
      return letters.value;
    } catch (error) {
      messages.alert(strings.wordsFailed((error as Error).message));
      return null;
    }
  }

  /**
   * The page with its words where they hide no face.
   * @param only the words that may move; all unless told
   */
  function settled(page: PageDocument, only?: readonly number[]): PageDocument {
    const table = letters.peek();
    const all = page.words ?? [];
    const stays = (i: number) => only !== undefined && !only.includes(i);
    if (!table || !all.some(({ auto }, i) => auto !== false && !stays(i))) return page;
    const album = store.album.peek();
    const subjects = Object.fromEntries(
      page.panels.flatMap(({ photo }) => {
        const meta = photo === null ? undefined : album.get(photo)?.meta;
        return meta ? [[photo, meta.subjects]] : [];
      }),
    );
    const fixed = all.map((word, i) => (stays(i) ? { ...word, auto: false } : word));
    const placed = table.settle({ ...page, words: fixed }, subjects);
    return { ...page, words: all.map((word, i) => (stays(i) ? word : placed[i])) };
  }

  /** Another page with the words of this one. */
  function on(page: PageDocument): PageDocument {
    return !page.words?.length && words.peek().length === 0 ? page : settled({ ...page, words: [...words.peek()] });
  }

  function settle(silent: boolean) {
    const page = store.page.peek();
    const next = page && settled(page);
    if (next && JSON.stringify(next.words) !== JSON.stringify(page.words))
      store.change({ type: 'change-page', page: next, silent });
  }
}

/** @returns all but the places that the core chooses */
function essence(words: readonly Word[]): string {
  return JSON.stringify(words.map((word) => (word.auto ? { ...word, x: 0, y: 0, tail: null } : word)));
}
