import { strings } from '../strings/strings.ts';
import { ChosenFiles } from './chosen-files.tsx';
import { useApp } from '../ui/context.ts';

const ID = 'files';

/** The one file input of the page; the buttons open it. */
export function FileInput() {
  const { intake } = useApp();
  return (
    <ChosenFiles
      id={ID}
      accept="image/*,video/*,.heic,.heif,.avif,.mkv,.srt,.vtt,.ass,.ssa,.sbv,.zip,.cbz"
      label={strings.filesLabel}
      onFiles={intake}
    />
  );
}

/** Opens the browser's file dialog. Must be called from a click or a key press. */
export function openFiles() {
  document.getElementById(ID)?.click();
}
