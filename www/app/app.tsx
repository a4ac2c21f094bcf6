import { LazyBrush } from '../brush/lazy-brush.tsx';
import { strings } from '../strings/strings.ts';
import { CarriedPhoto } from '../page/panels/carried-photo.tsx';
import { useApp } from '../ui/context.ts';
import { STYLE_ZONE, dragging, forStyle } from './drop.ts';
import { Broken } from '../storage/broken.tsx';
import { Guard } from './guard.tsx';
import { EncodingDialog } from '../ui/encoding-dialog.tsx';
import { QuestionDialog } from '../ui/question-dialog.tsx';
import { Start } from './start.tsx';
import { Toasts } from './toasts.tsx';
import { TopBar } from './top-bar.tsx';

/** The whole window. If the project cannot be shown, it offers ways to continue. */
export function App() {
  return (
    <Guard instead={<Unshown />}>
      <Everything />
    </Guard>
  );
}

/** Replaces a project that the views cannot draw. */
function Unshown() {
  const { ui, screens } = useApp();
  const projects = ui.work.value === 'projects';
  return (
    <div class="app" data-view="start" data-work={projects ? 'projects' : undefined}>
      <header class="top-bar">
        <div class="top-start">
          <h1 class="brand">{strings.name}</h1>
        </div>
      </header>
      {projects ? (
        <screens.projects />
      ) : (
        <main class="start">
          <div class="start-body alone">
            <Broken />
          </div>
        </main>
      )}
      <Toasts />
    </div>
  );
}

function Everything() {
  const { store, ui, keeping, screens } = useApp();
  const empty = store.tray.value.length === 0;
  const dialog = ui.dialog.value;
  const work = ui.work.value;
  const projects = work === 'projects';
  const Workspace = work !== null && (projects || !empty) ? screens[work] : null;
  return (
    <div
      class="app"
      data-view={empty ? 'start' : 'board'}
      data-preview={ui.preview.value && !ui.work.value}
      data-sheet={ui.sheet.value ?? 'none'}
      data-work={empty && !projects ? undefined : (ui.work.value ?? undefined)}
    >
      <TopBar />
      {!empty ? <screens.board /> : keeping.running.value ? <Waiting /> : !projects && <Start />}
      {Workspace && <Workspace />}
      <CarriedPhoto />
      <Toasts />
      <EncodingDialog />
      <QuestionDialog />
      {dialog === 'help' && <screens.help />}
      {typeof dialog === 'object' && dialog !== null && <LazyBrush key={dialog.brush} id={dialog.brush} />}
      {dialog === 'export' && store.page.value && <screens.export />}
      {dragging.value && (
        <div class="drop-veil" data-zones={!empty} data-for={forStyle.value ? 'style' : 'photos'}>
          <p>{strings.dropHere}</p>
          {!empty && (
            <p class="drop-style" data-drop={STYLE_ZONE}>
              {strings.dropForStyle}
            </p>
          )}
        </div>
      )}
    </div>
  );
}

/** While the project of the last visit is on its way. */
function Waiting() {
  return (
    <main class="start" aria-busy="true">
      <p class="visually-hidden">{strings.openingLast}</p>
    </main>
  );
}
