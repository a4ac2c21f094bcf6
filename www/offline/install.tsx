import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';

/** Installs the app on the device; hidden if the browser does not support it. */
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
