import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';

/** Makes the page a program of the device; not there where the browser has no such way. */
export function InstallButton() {
  const { installing } = useApp();
  if (!installing.possible.value) return null;
  return (
    <button type="button" class="button install" title={strings.installHelp} onClick={installing.install}>
      <Icon name="install" />
      {strings.install}
    </button>
  );
}
