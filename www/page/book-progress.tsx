/** Progress of a book that is being made, with a button that cancels it. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';

export function BookProgress() {
  const { bookMaking, actions } = useApp();
  const progress = bookMaking.progress.value;
  if (progress === null) return null;
  const { done, of } = progress;
  const label = of === 0 ? strings.book.looking : strings.book.making({ page: done + 1, of });
  return (
    <div class="book-making" aria-busy="true">
      <span>{label}</span>
      <progress
        class="progress"
        aria-label={label}
        value={of === 0 ? undefined : done}
        max={of === 0 ? undefined : of}
      />
      <ActionButton action={actions.book.cancel} class="button" text />
    </div>
  );
}
