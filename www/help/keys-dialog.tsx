import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Dialog } from '../ui/dialog.tsx';
import { keyLines } from './key-lines.ts';

/** The list of keys. */
export function KeysDialog() {
  const { ui, actions } = useApp();
  return (
    <Dialog
      title={strings.keys}
      class="keys-dialog"
      onClose={() => {
        ui.dialog.value = null;
      }}
    >
      <dl class="keys">
        {keyLines(actions).map(({ keys, does }) => (
          <div key={does}>
            <dt>
              {keys.map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
      <label class="letter-keys">
        <input
          type="checkbox"
          checked={ui.letterKeys.value}
          onChange={({ currentTarget }) => ui.useLetterKeys(currentTarget.checked)}
        />
        <span>{strings.letterKeys}</span>
      </label>
    </Dialog>
  );
}
