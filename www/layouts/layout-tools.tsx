/** What can be done with the layout as a whole: a surprise, changes by hand, files. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ChosenFiles, JSON_FILES } from '../photos/chosen-files.tsx';
import { useApp } from '../app/context.ts';
import { Icon } from '../ui/icon.tsx';

export function LayoutTools() {
  const { store, reshaping, ownLayouts } = useApp();
  const file = useRef(null as HTMLInputElement | null);
  const facts = store.layoutFacts.value;
  const editing = reshaping.editing.value;
  return (
    <div class="layout-tools">
      <button
        type="button"
        class="button small"
        disabled={facts === null}
        aria-label={strings.surprise}
        title={strings.surprise}
        onClick={reshaping.surprise}
      >
        <Icon name="surprise" />
        {strings.surpriseShort}
      </button>
      <IconButton
        icon="edit"
        label={strings.editLayout}
        disabled={facts === null}
        pressed={editing}
        onClick={() => {
          reshaping.editing.value = !editing;
        }}
      />
      <IconButton icon="save" label={strings.saveLayout} disabled={facts === null} onClick={ownLayouts.save} />
      <IconButton icon="open" label={strings.loadLayout} onClick={() => file.current?.click()} />
      {facts && ownLayouts.isOwn(facts.id) && (
        <IconButton icon="bin" label={strings.forgetLayout} onClick={() => ownLayouts.remove(facts.id)} />
      )}
      <ChosenFiles input={file} accept={JSON_FILES} label={strings.layoutFile} onFiles={ownLayouts.open} />
    </div>
  );
}
