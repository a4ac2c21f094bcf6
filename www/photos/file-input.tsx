import { strings } from '../strings/strings.ts';
import { endingsOf } from '../engine/file-kinds.ts';
import { ChosenFiles } from './chosen-files.tsx';
import { useApp } from '../ui/context.ts';

const ID = 'files';
const ACCEPT = `image/*,video/*,${endingsOf('photo', 'video', 'subtitles', 'archive', 'painters')}`;

/** The one file input of the page; the buttons open it. */
export function FileInput() {
  const { intake } = useApp();
  return <ChosenFiles id={ID} accept={ACCEPT} label={strings.filesLabel} onFiles={intake} />;
}

/** Opens the browser's file dialog. Must be called from a click or a key press. */
export function openFiles() {
  document.getElementById(ID)?.click();
}
