/** The versions of the page: previous, next, all of them, and the heart. */

import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

export function Versions({ heart = false }: { heart?: boolean }) {
  const { store, actions } = useApp();
  const { page } = actions;
  const [at, of] = [store.versionIndex.value + 1, store.versions.value.length];
  return (
    <div class="versions" data-one={of < 2}>
      <ActionButton action={page.previous} />
      <ActionButton action={page.versions} class="page-number">
        {heart ? (
          strings.versionAt({ n: at, of })
        ) : (
          <>
            <span>
              {at}
              <i>/</i>
              {of}
            </span>
            <span class="icon-text">{strings.versionLabel}</span>
          </>
        )}
      </ActionButton>
      <ActionButton action={page.next} />
      {heart && <ActionButton action={page.favourite} class="icon-button page-heart" />}
    </div>
  );
}
