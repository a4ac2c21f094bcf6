import { BoardSwitch } from '../boards/board-switch.tsx';
import { position, versions } from '../document/history.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { LanguageAndTheme } from '../help/language-and-theme.tsx';
import { FileInput } from '../photos/file-input.tsx';
import { ProjectBar } from '../storage/project-bar.tsx';
import { Workspaces } from './workspaces.tsx';
import { ActionButton } from '../ui/action-button.tsx';

/** The quiet bar above: the name, the steps through time, the ways out. */
export function TopBar() {
  const { store, ui, actions } = useApp();
  const compact = !ui.wide.value;
  const page = store.page.value;
  return (
    <header class="top-bar">
      <div class="top-start">
        {store.tray.value.length === 0 && ui.work.value !== 'projects' ? (
          <span class="brand">{strings.name}</span>
        ) : (
          <h1 class="brand">{strings.name}</h1>
        )}
        <ProjectBar />
      </div>
      <FileInput />
      <div class="top-middle">{page && <Steps />}</div>
      <div class="top-end">
        {page && !compact && <BoardSwitch />}
        {page && !compact && <Workspaces />}
        {/* On a small screen it is among the page's settings: the bar has room for eight fingers. */}
        {(!compact || !page) && <LanguageAndTheme />}
        {(!compact || !page) && <ActionButton action={actions.window.help} />}
        {compact && page && (
          <>
            <ActionButton action={actions.window.settings} />
            <ActionButton action={actions.download.download} />
          </>
        )}
        {page && !compact && (
          <>
            <ActionButton action={actions.download.exportPages} class="button" text />
            <ActionButton action={actions.download.download} class="button strong" text />
          </>
        )}
      </div>
    </header>
  );
}

/** Undo and redo, and the versions of the page that were shown so far. */
function Steps() {
  const { store, ui, actions } = useApp();
  const { page } = actions;
  const history = store.history.value;
  return (
    <>
      <ActionButton action={page.undo} />
      <ActionButton action={page.redo} />
      <span class="divider" />
      <ActionButton action={page.previous} />
      <ActionButton action={page.versions} class="page-number">
        {ui.roomy.value ? (
          strings.versionAt(position(history) + 1, versions(history).length)
        ) : (
          <>
            {position(history) + 1}
            <i>/</i>
            {versions(history).length}
          </>
        )}
      </ActionButton>
      <ActionButton action={page.next} />
      {ui.wide.value && <ActionButton action={page.favourite} class="icon-button page-heart" />}
    </>
  );
}
