import { position, versions } from '../document/history.ts';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useApp } from './context.ts';
import { FileInput } from '../photos/file-input.tsx';
import { Icon } from '../ui/icon.tsx';
import { ProjectBar } from '../storage/project-bar.tsx';
import { Workspaces } from './workspaces.tsx';

/** The quiet bar above: the name, the steps through time, the ways out. */
export function TopBar() {
  const { store, download, ui } = useApp();
  const compact = !ui.wide.value;
  const running = download.progress.value;
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
        {page && !compact && <Workspaces />}
        <ThemeButton />
        {!compact && (
          <IconButton
            icon="help"
            label={strings.keys}
            shortcut="?"
            onClick={() => {
              ui.dialog.value = 'keys';
            }}
          />
        )}
        {compact && page && (
          <IconButton
            icon="settings"
            label={strings.pageSettings}
            pressed={ui.sheet.value === 'settings'}
            onClick={() => {
              ui.sheet.value = ui.sheet.value === 'settings' ? null : 'settings';
            }}
          />
        )}
        {page && compact && (
          <IconButton
            icon="download"
            label={strings.download}
            disabled={running !== null}
            onClick={() => download.start()}
          />
        )}
        {page && !compact && (
          <>
            <button
              type="button"
              class="button"
              onClick={() => {
                ui.dialog.value = 'export';
              }}
            >
              <Icon name="export" />
              {strings.export}
            </button>
            <button type="button" class="button strong" disabled={running !== null} onClick={() => download.start()}>
              <Icon name="download" />
              {strings.download}
            </button>
          </>
        )}
      </div>
    </header>
  );
}

/** Undo and redo, and the versions of the page that were shown so far. */
function Steps() {
  const { store, pages, ui, shownPages } = useApp();
  const history = store.history.value;
  const at = position(history);
  const { length } = versions(history);
  return (
    <>
      <IconButton
        icon="undo"
        label={strings.undo}
        shortcut="Ctrl+Z"
        disabled={history.past.length === 0}
        onClick={pages.undo}
      />
      <IconButton
        icon="redo"
        label={strings.redo}
        shortcut="Shift+Ctrl+Z"
        disabled={history.future.length === 0}
        onClick={pages.redo}
      />
      <span class="divider" />
      <IconButton
        icon="previous"
        label={strings.previous}
        help={strings.previousHelp}
        disabled={at <= 0}
        onClick={pages.previous}
      />
      <button
        type="button"
        class="page-number"
        aria-label={strings.pagesShownAt(at + 1, length)}
        title={strings.version(at + 1, length)}
        aria-pressed={ui.work.value === 'pages'}
        onClick={() => {
          ui.work.value = ui.work.value === 'pages' ? null : 'pages';
        }}
      >
        {at + 1}
        <i>/</i>
        {length}
      </button>
      <IconButton
        icon="next"
        label={strings.next}
        help={strings.nextHelp}
        disabled={at >= length - 1}
        onClick={pages.next}
      />
      {ui.wide.value && (
        <IconButton
          icon="heart"
          label={strings.favouritePage}
          pressed={shownPages.loved.value}
          class="page-heart"
          onClick={shownPages.loveThis}
        />
      )}
    </>
  );
}

function ThemeButton() {
  const { ui } = useApp();
  const dark = (ui.theme.value ?? (ui.systemDark.value ? 'dark' : 'light')) === 'dark';
  return (
    <IconButton
      icon={dark ? 'sun' : 'moon'}
      label={dark ? strings.theme.light : strings.theme.dark}
      onClick={ui.toggleTheme}
    />
  );
}
