/** Messages about an undo step. They close when they are out of date. */

import { effect } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Mirror } from '../document/history.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Messages, Way } from './messages.ts';

type Parts = { messages: Pick<Messages, 'list' | 'note' | 'close'>; store: Pick<Store, 'mirror'> };

/**
 * Shows a message about the last action, with an undo button. The message closes after another step or undo, because
 * its button would undo something else.
 */
export function noteWithUndo({ pages, ...parts }: Parts & { pages: Pick<Pages, 'undo'> }, text: string) {
  const { step } = parts.store.mirror.peek();
  const id = parts.messages.note(text, { label: strings.undo, run: pages.undo });
  closeWhen(parts, id, (now) => now.step !== step);
}

/** Shows a message about the last action. The message closes when the action is undone. */
export function noteUntilUndo(parts: Parts, text: string, way?: Way, more?: Way) {
  const { undos } = parts.store.mirror.peek();
  const id = parts.messages.note(text, way, more);
  closeWhen(parts, id, (now) => now.undos < undos);
}

function closeWhen({ messages, store }: Parts, id: number, isOver: (now: Mirror) => boolean) {
  const stop = effect(() => {
    const over = isOver(store.mirror.value);
    const gone = messages.list.value.every((message) => message.id !== id);
    if (!over && !gone) return;
    // Do not change signals while they notify.
    queueMicrotask(() => {
      stop();
      messages.close(id);
    });
  });
}
