// @ts-check
import { strings } from '../strings.js';
import { useApp } from './context.js';
import { Dialog } from './dialog.jsx';

/** The list of keys. */
export function KeysDialog() {
  const { ui } = useApp();
  return (
    <Dialog title={strings.keys} class="keys-dialog" onClose={() => { ui.dialog.value = null; }}>
      <dl class="keys">
        {strings.keyList.map(({ keys, does }) => (
          <div key={does}>
            <dt>{keys.map((key) => <kbd key={key}>{key}</kbd>)}</dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
    </Dialog>
  );
}
