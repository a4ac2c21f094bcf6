import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

/** The views of the album: the pages, the storyboard, and the two workspaces of styles. */
export function Views() {
  const { comic, boards, designer, explorer } = useApp().actions.window;
  return (
    <div class="views" role="group" aria-label={strings.boards.seen}>
      {[comic, boards, designer, explorer].map((action) => (
        <ActionButton key={action.label} action={{ ...action, icon: undefined }} class="view" text />
      ))}
    </div>
  );
}
