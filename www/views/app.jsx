// @ts-check
import { strings } from '../strings.js';
import { Board } from './board.jsx';
import { useApp } from './context.js';
import { Designer } from './designer/designer.jsx';
import { dragging } from './drop.js';
import { Explorer } from './explorer/explorer.jsx';
import { ExportDialog } from './export-dialog.jsx';
import { Broken } from './keeping/broken.jsx';
import { PagesWall } from './keeping/pages-wall.jsx';
import { Projects } from './keeping/projects.jsx';
import { Guard } from './guard.jsx';
import { KeysDialog } from './keys-dialog.jsx';
import { Start } from './start.jsx';
import { Toasts } from './toasts.jsx';
import { TopBar } from './top-bar.jsx';

/** The whole window; where the project cannot be shown, the ways on from there. */
export function App() {
  return <Guard instead={<Unshown />}><Everything /></Guard>;
}

/** In the place of a project that the views cannot draw. */
function Unshown() {
  const { ui } = useApp();
  const projects = ui.work.value === 'projects';
  return (
    <div class="app" data-view="start" data-work={projects ? 'projects' : undefined}>
      <header class="top-bar"><div class="top-start"><h1 class="brand">{strings.name}</h1></div></header>
      {projects ? <Projects /> : <main class="start"><div class="start-body alone"><Broken /></div></main>}
      <Toasts />
    </div>
  );
}

function Everything() {
  const { store, ui, keeping } = useApp();
  const empty = store.tray.value.length === 0;
  const dialog = ui.dialog.value;
  const projects = ui.work.value === 'projects';
  return (
    <div class="app" data-view={empty ? 'start' : 'board'} data-sheet={ui.sheet.value ?? 'none'} data-work={empty && !projects ? undefined : ui.work.value ?? undefined}>
      <TopBar />
      {!empty ? <Board /> : keeping.running.value ? <Waiting /> : !projects && <Start />}
      {!empty && ui.work.value === 'designer' && <Designer />}
      {!empty && ui.work.value === 'explorer' && <Explorer />}
      {!empty && ui.work.value === 'pages' && <PagesWall />}
      {projects && <Projects />}
      <Toasts />
      {dialog === 'keys' && <KeysDialog />}
      {dialog === 'export' && store.page.value && <ExportDialog />}
      {dragging.value && <div class="drop-veil"><p>{strings.dropHere}</p></div>}
    </div>
  );
}

/** While the project of the last visit is on its way. */
function Waiting() {
  return <main class="start" aria-busy="true"><p class="visually-hidden">{strings.openingLast}</p></main>;
}
