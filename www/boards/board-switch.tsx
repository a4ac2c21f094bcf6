/** How the album is seen: as the pages of a comic, or as a board. */

import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { useLoaded } from '../ui/loaded.ts';

export function BoardSwitch() {
  const { ui } = useApp();
  const board = ui.work.value === 'boards';
  const show = (on: boolean) => () => {
    ui.sheet.value = null;
    ui.work.value = on ? 'boards' : null;
  };
  return (
    <div class="board-switch" role="group" aria-label={strings.boards.seen}>
      <button type="button" class="button" aria-pressed={!board} onClick={show(false)}>
        {strings.boards.comic}
      </button>
      <button type="button" class="button" aria-pressed={board} onClick={show(true)}>
        {strings.boards.board}
      </button>
    </div>
  );
}

/** The board itself comes when it is first asked for. */
export function LazyBoards() {
  const { messages, ui } = useApp();
  const loaded = useLoaded(
    () => import('./boards-screen.tsx'),
    () => {
      ui.work.value = null;
      messages.alert(strings.boards.missing);
    },
  );
  return loaded ? <loaded.BoardsScreen /> : <main class="workspace" aria-busy="true" />;
}
