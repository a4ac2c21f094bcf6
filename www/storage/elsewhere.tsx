import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';

/** Says that another tab has the project, and offers a copy. */
export function Elsewhere() {
  const { keeping, ui } = useApp();
  const other = keeping.elsewhere.value;
  if (!other) return null;
  return (
    <div class="elsewhere">
      <p>
        {strings.openElsewhere({ name: other.name || strings.untitled })} {other.follows && strings.opensWhenFree}
      </p>
      <button
        type="button"
        class="button"
        onClick={() =>
          void keeping.openCopy().then((done) => {
            if (done) ui.work.value = null;
          })
        }
      >
        {strings.openCopy}
      </button>
    </div>
  );
}
