/** The project list of this browser, with thumbnails and actions. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { EXTENSION } from './files/project-file.ts';
import { Picture } from './picture.tsx';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { InstallButton } from '../offline/install.tsx';
import { Workspace } from '../ui/workspace.tsx';
import { Broken } from './broken.tsx';
import { CleanChoice } from './clean-choice.tsx';
import { Elsewhere } from './elsewhere.tsx';
import { LONGEST_NAME, ProjectName, SaveState } from './project-bar.tsx';
import type { ProjectRecord } from './database.ts';

export function Projects() {
  const { store, keeping, ui, openProjects, actions } = useApp();
  const { projects } = actions;
  const input = useRef(null as HTMLInputElement | null);
  const list = keeping.list.value;
  const empty = store.tray.value.length === 0;
  const status = keeping.status.value;

  useEffect(() => void keeping.refresh().catch(() => {}), [status]);

  const openFile = { label: strings.openProject, icon: 'open', run: () => input.current?.click() };
  const tools = (
    <div class="wall-bar">
      <ActionButton action={projects.create} class="button" text />
      <ActionButton action={openFile} class="button" text />
      <ActionButton action={projects.save} class="button" text />
      {!empty && <CleanChoice />}
      <InstallButton />
      <ChosenFiles
        input={input}
        label={strings.projectFile}
        accept={`${EXTENSION},.png,.cbz,.zip`}
        onFiles={openProjects}
      />
    </div>
  );
  return (
    <Workspace
      title={strings.projects}
      class="projects"
      tools={tools}
      onClose={() => {
        ui.work.value = null;
      }}
    >
      <Elsewhere />
      <Broken />
      {!empty && !ui.wide.value && (
        <p class="project-now">
          <ProjectName />
          <SaveState />
        </p>
      )}
      <ul class="project-wall">
        {list.map((project) => (
          <Project key={project.id} project={project} />
        ))}
      </ul>
      {list.length === 0 && <p class="wall-empty">{strings.noProjects}</p>}
    </Workspace>
  );
}

function Project({ project: { id, name, changed, photos, picture } }: { project: ProjectRecord }) {
  const { keeping, ui } = useApp();
  const title = name || strings.untitled;
  const current = keeping.current.value === id;
  const busy = keeping.busy.value;
  const [renaming, setRenaming] = useState(false);

  async function open() {
    if (await keeping.open(id)) ui.work.value = null;
  }

  return (
    <li class="project" aria-label={title} data-current={current}>
      <button
        type="button"
        class="project-picture"
        aria-label={strings.openNamed({ name: title })}
        aria-current={current ? 'true' : undefined}
        disabled={busy && !current}
        onClick={() => void open()}
      >
        {picture && <Picture blob={picture} />}
      </button>
      <div class="project-about">
        {renaming ? (
          <NewName id={id} name={name} title={title} close={() => setRenaming(false)} />
        ) : (
          <strong>{title}</strong>
        )}
        <span>
          {changed > 0
            ? strings.projectAboutWhen({ photos, when: strings.moment(changed) })
            : strings.projectAbout({ photos })}
        </span>
      </div>
      <div class="project-tools">
        <IconButton
          icon="rename"
          label={strings.renameNamed({ name: title })}
          pressed={renaming}
          onClick={() => setRenaming(!renaming)}
        />
        <IconButton
          icon="duplicate"
          label={strings.duplicateNamed({ name: title })}
          onClick={() => void keeping.duplicate(id)}
        />
        <IconButton
          icon="bin"
          label={strings.deleteNamed({ name: title })}
          disabled={busy && current}
          onClick={() => void keeping.remove(id)}
        />
      </div>
    </li>
  );
}

/**
 * Replaces the name by an input with selected text. Enter and leaving the input accept the name, Escape discards it.
 */
function NewName({ id, name, title, close }: { id: string; name: string; title: string; close: () => void }) {
  const { keeping } = useApp();
  const field = useRef(null as HTMLInputElement | null);
  useEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);
  const left = useRef(false);
  const end = (take: boolean) => {
    if (left.current) return;
    left.current = true;
    const wanted = field.current?.value ?? '';
    if (take) void keeping.rename(id, wanted).finally(close);
    else close();
  };
  return (
    <input
      ref={field}
      type="text"
      class="project-rename"
      aria-label={strings.newNameOf({ name: title })}
      placeholder={strings.untitled}
      maxLength={LONGEST_NAME}
      autocomplete="off"
      spellcheck={false}
      defaultValue={name}
      onBlur={() => end(true)}
      onKeyDown={(event) => {
        if (event.key !== 'Enter' && event.key !== 'Escape') return;
        event.preventDefault();
        // Escape closes nothing else.
        event.stopPropagation();
        end(event.key === 'Enter');
      }}
    />
  );
}
