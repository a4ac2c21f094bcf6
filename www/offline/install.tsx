import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

/** Installs the app on the device; hidden if the browser does not support it. */
export function InstallButton() {
  const { installing, actions } = useApp();
  if (!installing.possible.value) return null;
  return <ActionButton action={actions.window.install} class="button install" text />;
}
