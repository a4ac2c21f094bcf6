/** How far the net is with the styles on the wall, and the way to end it. */

import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';

export function Judging() {
  const { explorer } = useApp();
  const progress = explorer.scores.progress.value;
  if (!progress) return null;
  return (
    <div class="judging">
      <progress
        class="progress"
        aria-label={strings.judging(progress.done, progress.total)}
        value={progress.done}
        max={progress.total}
      />
      <span class="count">{strings.judging(progress.done, progress.total)}</span>
      <button type="button" class="button small" onClick={explorer.scores.pause}>
        {strings.stopJudging}
      </button>
    </div>
  );
}
