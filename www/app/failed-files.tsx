import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Dialog } from '../ui/dialog.tsx';

/** Files that are damaged or could not be read, each with the reason. */
export function FailedFiles() {
  const { messages } = useApp();
  const { failures, unnamed, listed, list } = messages;
  const close = () => {
    listed.value = false;
  };
  return (
    <Dialog title={list.value.find(({ near }) => near)?.text ?? ''} onClose={close} class="failed-files">
      <ul>
        {failures.value.map(({ name, why, way }) => (
          <li key={`${name}\n${why}`}>
            <strong>{name}</strong>
            <span>{why}</span>
            {way && (
              <ActionButton
                action={{
                  label: way.label,
                  run() {
                    close();
                    way.run();
                  },
                }}
                class="button"
                text
              />
            )}
          </li>
        ))}
      </ul>
      {unnamed.value > 0 && <p class="quiet">{strings.moreFiles({ n: unnamed.value })}</p>}
    </Dialog>
  );
}
