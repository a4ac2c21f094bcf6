import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { useLoaded } from '../ui/loaded.ts';

/** The storyboard, loaded when it is opened first. */
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
