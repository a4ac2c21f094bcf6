/** Layout controls: random layout, manual changes, files. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ChosenFiles, JSON_FILES } from '../photos/chosen-files.tsx';
import { useApp } from '../ui/context.ts';
import { isEnabled } from '../ui/action.ts';
import { ActionButton } from '../ui/action-button.tsx';

export function LayoutTools() {
  const { ownLayouts, ui, actions } = useApp();
  const { surprise, edit, save, forget } = actions.layouts;
  const file = useRef(null as HTMLInputElement | null);
  return (
    <div class="layout-tools">
      <ActionButton action={surprise} class="button small" text />
      {!ui.wide.value && (
        <ActionButton action={{ ...edit, short: strings.editLayoutShort }} class="button small" text />
      )}
      <ActionButton action={save} />
      <IconButton icon="open" label={strings.loadLayout} onClick={() => file.current?.click()} />
      {isEnabled(forget) && <ActionButton action={forget} />}
      <ChosenFiles input={file} accept={JSON_FILES} label={strings.layoutFile} onFiles={ownLayouts.open} />
    </div>
  );
}
