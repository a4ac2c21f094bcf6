// @ts-check
import { strings } from '../strings.js';
import { useApp } from './context.js';

const ID = 'files';

/** The one file input of the page; the buttons open it. */
export function FileInput() {
  const { reading } = useApp();
  return (
    <input
      id={ID}
      class="visually-hidden"
      type="file"
      multiple
      accept="image/*,video/*"
      aria-label={strings.filesLabel}
      tabIndex={-1}
      onChange={({ currentTarget }) => {
        reading.addFiles([...(currentTarget.files ?? [])]);
        // The same file can be chosen again.
        currentTarget.value = '';
      }}
    />
  );
}

/** Opens the browser's file dialog. Must be called from a click or a key press. */
export function openFiles() {
  document.getElementById(ID)?.click();
}
