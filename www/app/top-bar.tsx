import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { FileInput } from '../photos/file-input.tsx';
import { ProjectBar } from '../storage/project-bar.tsx';
import { Versions } from '../page/versions.tsx';
import { AppMenu } from './app-menu.tsx';
import { Views } from './views.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import { Icon } from '../ui/icon.tsx';

/** The quiet bar above: the project, undo, the views, and the exports. On a small screen the views are in the menu. */
export function TopBar() {
  const { store, ui, actions } = useApp();
  const wide = ui.wide.value;
  const page = store.page.value;
  return (
    <header class="top-bar">
      {page && ui.work.value === null && <SkipToPage />}
      <div class="top-start">
        {store.tray.value.length === 0 && ui.work.value !== 'projects' ? (
          <span class="brand">{strings.name}</span>
        ) : (
          <h1 class="brand">{strings.name}</h1>
        )}
        <ProjectBar />
        {page && wide && <Steps />}
      </div>
      <FileInput />
      <div class="top-middle">
        {page && wide && <Views />}
        {page && !wide && (
          <>
            <Steps />
            <Versions />
          </>
        )}
      </div>
      <div class="top-end">
        <AppMenu />
        {page && wide && <Ways />}
        {page && !wide && (
          <ActionButton action={actions.download.download} tells>
            <Icon name="download" />
            <span class="icon-text">PNG</span>
          </ActionButton>
        )}
      </div>
    </header>
  );
}

/** Leads the keyboard past the bar and the photos. It is visible while it has the focus. */
function SkipToPage() {
  return (
    <button
      type="button"
      class="skip-link"
      onClick={() => document.querySelector<HTMLElement>('.panels > .panel[tabindex="0"]')?.focus()}
    >
      {strings.skipToPage}
    </button>
  );
}

function Steps() {
  const { page } = useApp().actions;
  return (
    <div class="steps">
      <ActionButton action={page.undo} />
      <ActionButton action={page.redo} />
    </div>
  );
}

/** One button in two parts: all exports, and the fastest one. */
function Ways() {
  const { exportPages, download } = useApp().actions.download;
  return (
    <div class="ways">
      <ActionButton action={exportPages} class="button strong" text />
      <ActionButton action={download} class="button strong">
        <Icon name="download" />
        <span>PNG</span>
      </ActionButton>
    </div>
  );
}
