/** A button for the browser's file dialog: a hidden input with an accessible name. */

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

/** File types of JSON files. */
export const JSON_FILES = '.json,application/json';
