import { effect } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Messages } from '../ui/messages.ts';

type Parts = { messages: Messages; store: Pick<Store, 'step'>; pages: Pick<Pages, 'undo'> };

/**
 * Shows a message about the last action, with an undo button. The message closes after another step or undo, because
 * its button would undo something else.
 */
export function noteWithUndo({ messages, store, pages }: Parts, text: string) {
  const id = messages.note(text, { label: strings.undo, run: pages.undo });
  const step = store.step.peek();
  const stop = effect(() => {
    const moved = store.step.value !== step;
    const gone = messages.list.value.every((message) => message.id !== id);
    if (!moved && !gone) return;
    // Do not change signals while they notify.
    queueMicrotask(() => {
      stop();
      messages.close(id);
    });
  });
}
