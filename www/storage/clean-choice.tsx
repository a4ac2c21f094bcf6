/** The choice whether a project file contains location and camera data. */

import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';

export function CleanChoice() {
  const { on, turn } = useApp().keeping.files.clean;
  return (
    <label class="check" title={strings.removeMetadataHelp}>
      <input type="checkbox" checked={on.value} onChange={({ currentTarget }) => turn(currentTarget.checked)} />
      {strings.removeMetadata}
    </label>
  );
}
