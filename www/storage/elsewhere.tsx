import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';

/** Says that another tab has the project, and offers a copy. */
export function Elsewhere() {
  const { keeping, actions } = useApp();
  const other = keeping.elsewhere.value;
  if (!other) return null;
  return (
    <div class="elsewhere">
      <p>
        {strings.openElsewhere({ name: other.name || strings.untitled })} {other.follows && strings.opensWhenFree}
      </p>
      <ActionButton action={actions.projects.openCopy} class="button" text />
    </div>
  );
}
