/** The browser's own file dialog behind a button: an input that nobody sees and everybody can name. */

import type { RefObject } from 'preact';

/** @param props `input`: to open it by a click */
export function ChosenFiles({
  label,
  accept,
  onFiles,
  id,
  input,
}: {
  label: string;
  accept: string;
  onFiles: (files: File[]) => void;
  id?: string;
  input?: RefObject<HTMLInputElement | null>;
}) {
  return (
    <input
      ref={input}
      id={id}
      class="visually-hidden"
      type="file"
      multiple
      accept={accept}
      aria-label={label}
      tabIndex={-1}
      onChange={({ currentTarget }) => {
        onFiles([...(currentTarget.files ?? [])]);
        // The same file can be chosen again.
        currentTarget.value = '';
      }}
    />
  );
}

/** What JSON files are called. */
export const JSON_FILES = '.json,application/json';
