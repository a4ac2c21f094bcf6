import { strings } from '../strings/strings.ts';
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
              <button
                type="button"
                class="button"
                onClick={() => {
                  close();
                  way.run();
                }}
              >
                {way.label}
              </button>
            )}
          </li>
        ))}
      </ul>
      {unnamed.value > 0 && <p class="quiet">{strings.moreFiles({ n: unnamed.value })}</p>}
    </Dialog>
  );
}
