/** Actions for the current page of the storyboard. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { PageDocument } from '../engine/types.ts';
import type { App } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';

export function createBookActions({
  store,
  book,
  bookMaking,
  framing,
  messages,
  selection,
  ui,
}: Pick<App, 'store' | 'book' | 'bookMaking' | 'framing' | 'messages' | 'selection' | 'ui'>) {
  const { at, several } = book;
  const last = computed(() => at.value === store.project.value.others.length);
  const whyNotAdd = computed(book.cannotAdd);
  const whyNotSpread = computed(book.cannotSpread);
  /** Asks before new pages replace pages with manual changes. */
  function asked(run: () => void) {
    if (store.sheets.peek().some(isHandMade))
      ui.question.value = { text: strings.book.spreadAsk, yes: strings.book.spreadYes, run };
    else run();
  }

  return {
    turnBack: {
      label: strings.book.turnBack,
      keys: ['PageUp'],
      about: strings.keyAbout.turn,
      enabled: several,
      run: () => book.step(-1),
    },
    turnOn: {
      label: strings.book.turnOn,
      keys: ['PageDown'],
      about: strings.keyAbout.turn,
      enabled: several,
      run: () => book.step(1),
    },
    add: {
      label: strings.book.add,
      help: computed(
        () =>
          whyNotAdd.value ||
          (book.left.value.length > 0 ? strings.book.addMore({ left: book.left.value.length }) : strings.book.addHelp),
      ),
      icon: 'add',
      enabled: computed(() => whyNotAdd.value === ''),
      run: book.add,
      undo: 'step',
    },
    cancel: { label: strings.cancel, run: () => bookMaking.cancel() },
    make: {
      label: strings.book.make,
      help: computed(() => whyNotSpread.value || strings.book.makeHelp({ n: store.photos.value.length })),
      icon: 'book',
      enabled: computed(() => whyNotSpread.value === '' && bookMaking.progress.value === null),
      run: () => asked(() => bookMaking.make('one')),
      undo: 'step',
    },
    makeChapters: {
      label: strings.book.makeChapters,
      help: computed(() => whyNotSpread.value || strings.book.makeChaptersHelp),
      icon: 'book',
      enabled: computed(
        () =>
          book.isMade.value && book.hasDays.value && whyNotSpread.value === '' && bookMaking.progress.value === null,
      ),
      run: () => asked(() => bookMaking.make('chapters')),
      undo: 'step',
    },
    cover: {
      label: strings.book.cover,
      help: computed(() => strings.book.coverHelp),
      icon: 'photos',
      enabled: book.isMade,
      run() {
        book.go(book.coverAt());
        selection.set([0]);
        framing.mode.value = { kind: 'replace', panel: 0 };
        if (!ui.wide.peek()) ui.sheet.value = 'photos';
      },
    },
    spread: {
      label: strings.book.spreadAlbum,
      help: computed(() => whyNotSpread.value || strings.book.spreadHelp({ n: store.photos.value.length })),
      icon: 'spread',
      enabled: computed(() => whyNotSpread.value === ''),
      run: () => asked(book.spreadAlbum),
      undo: 'step',
    },
    earlier: {
      label: strings.book.earlier,
      icon: computed(() => (ui.wide.value ? 'up' : 'previous')),
      enabled: computed(() => at.value > 0),
      run: () => book.move(at.peek(), at.peek() - 1),
      undo: 'step',
    },
    later: {
      label: strings.book.later,
      icon: computed(() => (ui.wide.value ? 'down' : 'next')),
      enabled: computed(() => !last.value),
      run: () => book.move(at.peek(), at.peek() + 1),
      undo: 'step',
    },
    remove: { label: strings.book.remove, icon: 'bin', enabled: several, run: book.remove, undo: 'step' },
    styleAll: {
      label: strings.book.styleAll,
      icon: 'style',
      enabled: computed(() => !book.oneStyle.value),
      run: book.styleAll,
      undo: 'step',
    },
  } satisfies Record<string, Action>;
}

/** Whether the user wrote on the page, or moved or locked photos. */
function isHandMade({ panels, words = [] }: PageDocument): boolean {
  // The close crops on the end page of a book are automatic.
  const isBook = words.some(({ book }) => book);
  return words.some(({ made }) => !made) || panels.some(({ edited, locked }) => (edited && !isBook) || locked);
}
