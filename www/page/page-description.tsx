/** A text description of the page, for copying. */

import { describePage } from './describing.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { styleOfPage } from '../styles/style-actions.ts';

export function PageDescription() {
  const app = useApp();
  const { store, messages } = app;
  const page = store.page.value;
  if (page === null) return null;
  const style = styleOfPage(app);
  const text = describePage(page, store.album.value, style ? strings.styleTitle(style) : strings.ownStyle);

  const copy = {
    label: strings.copyDescription,
    help: strings.descriptionHelp,
    run() {
      // The clipboard is only available on secure origins.
      (navigator.clipboard?.writeText(text) ?? Promise.reject(new Error('no clipboard'))).then(
        () => messages.note(strings.descriptionCopied),
        () => messages.alert(strings.descriptionNotCopied({ text })),
      );
    },
  };

  return (
    <details class="page-description">
      <summary>{strings.description}</summary>
      <p class="quiet">{text}</p>
      <ActionButton action={copy} class="button small" text />
    </details>
  );
}
