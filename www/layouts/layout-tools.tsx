/** Layout controls: random layout, manual changes, files. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ChosenFiles, JSON_FILES } from '../photos/chosen-files.tsx';
import { useApp } from '../ui/context.ts';
import { isEnabled } from '../ui/action.ts';
import { ActionButton } from '../ui/action-button.tsx';

export function LayoutTools() {
  const { ownLayouts, ui, actions } = useApp();
  const { surprise, edit, save, forget } = actions.layouts;
  const file = useRef(null as HTMLInputElement | null);
  const load = {
    label: strings.loadLayout,
    short: strings.loadLayoutShort,
    icon: 'open',
    run: () => file.current?.click(),
  };
  return (
    <div class="layout-tools">
      <ActionButton action={surprise} class="button small" text />
      {!ui.wide.value && (
        <ActionButton action={{ ...edit, short: strings.editLayoutShort }} class="button small" text />
      )}
      <ActionButton action={save} class="button small" text />
      <ActionButton action={load} class="button small" text />
      {isEnabled(forget) && <ActionButton action={forget} />}
      <ChosenFiles input={file} accept={JSON_FILES} label={strings.layoutFile} onFiles={ownLayouts.open} />
    </div>
  );
}
