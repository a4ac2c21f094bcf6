/** Project controls in the top bar: name, save state, and access to other projects. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import type { Keeping } from './storage.ts';

/** Characters of a name. */
export const LONGEST_NAME = 80;

export function ProjectBar() {
  const { store, ui } = useApp();
  const empty = store.tray.value.length === 0;
  if (!ui.wide.value) return <ProjectsButton small dot={!empty} />;
  if (empty) return <ProjectsButton />;
  return (
    <>
      <ProjectName />
      <SaveState />
      <ProjectsButton small />
    </>
  );
}

/** Editable project name. Escape discards the edit. */
export function ProjectName() {
  const { store, reading } = useApp();
  const { name } = store.project.value;
  return (
    <input
      type="text"
      class="project-name"
      aria-label={strings.projectName}
      placeholder={strings.untitled}
      maxLength={LONGEST_NAME}
      autocomplete="off"
      spellcheck={false}
      title={name || undefined}
      value={name}
      onChange={({ currentTarget }) => {
        // An empty name restores the automatic name.
        store.change({ type: 'rename', name: currentTarget.value.trim() || reading.automaticName() });
        currentTarget.value = store.project.peek().name;
      }}
      onKeyDown={(event) => {
        if (event.key !== 'Enter' && event.key !== 'Escape') return;
        if (event.key === 'Escape') event.currentTarget.value = name;
        event.preventDefault();
        event.currentTarget.blur();
      }}
    />
  );
}

/** Save state, with an action if saving failed. */
export function SaveState() {
  const { keeping, actions } = useApp();
  const state = keeping.status.value;
  const text = stateText(keeping);
  if (text === '') return null;
  // On small screens the text is shorter.
  if (state === 'saving' || state === 'saved')
    return (
      <span class="save-state" data-state={state} title={`${text}. ${strings.saveHelp}`}>
        {text}
      </span>
    );
  const saveFile = { ...actions.projects.save, label: text, help: `${text}. ${strings.saveToFile}`, icon: 'alert' };
  return <ActionButton action={saveFile} class="save-state" text />;
}

function stateText({ status, progress }: Keeping) {
  const [state, files] = [status.value, progress.value];
  return state === 'saving' && files && files.total > 1
    ? strings.savingCount({ done: files.done, total: files.total })
    : strings.saveState[state];
}

/** @param props `dot`: it also marks unsaved changes, if there is no space for text */
function ProjectsButton({ small = false, dot = false }: { small?: boolean; dot?: boolean }) {
  const { keeping, actions } = useApp();
  const action = actions.projects.list;
  if (!small) return <ActionButton action={action} class="button" text />;
  const state = keeping.status.value;
  const text = dot ? stateText(keeping) : '';
  const waits = state === 'saving' ? (keeping.progress.value ? 'save-dot' : '') : 'save-dot bad';
  const sign = text === '' || state === 'saved' ? '' : waits;
  return (
    <ActionButton
      action={text ? { ...action, help: `${strings.projects}. ${text}` } : action}
      class={`icon-button ${sign}`}
    >
      <Icon name="open" />
      <span class="icon-text" aria-hidden="true">
        {strings.projects}
      </span>
    </ActionButton>
  );
}
