/**
 * Help: searchable topics and keyboard shortcuts. The search field is there at once, so that it receives the keys that
 * the user types while the topics are loaded.
 */

import { useState } from 'preact/hooks';
import { onceMore } from '../engine/once-more.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Dialog } from '../ui/dialog.tsx';
import { useLoaded } from '../ui/loaded.ts';

const { get: loadFound } = onceMore(() => import('./help-found.tsx'));

/** A field with the focus calls up the keyboard of a phone, which hides the topics. */
const byHand = () => window.matchMedia('(pointer: coarse)').matches;

function View() {
  const { ui, messages } = useApp();
  const [sought, setSought] = useState('');
  const close = () => {
    ui.dialog.value = null;
  };
  const found = useLoaded(loadFound, () => {
    close();
    messages.alert(strings.partMissing);
  });
  return (
    <Dialog title={strings.help} class="help-dialog" onClose={close}>
      <input
        type="search"
        class="search"
        aria-label={strings.searchHelp}
        placeholder={strings.searchHelp}
        autocomplete="off"
        spellcheck={false}
        autofocus={!byHand()}
        value={sought}
        onInput={({ currentTarget }) => setSought(currentTarget.value)}
        onKeyDown={(event) => {
          // Without this, the browser only empties the field.
          if (event.key === 'Escape') close();
        }}
      />
      {found && <found.HelpFound sought={sought} seek={setSought} close={close} />}
    </Dialog>
  );
}

export const HelpDialog = Object.assign(View, { preload: loadFound });
