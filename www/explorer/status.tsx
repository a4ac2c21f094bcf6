/**
 * Status line above the wall: the current task with a cancel button, or the next possible action. It is always as high,
 * so that the wall below never moves.
 */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';

export function Status() {
  return (
    <div class="explorer-status">
      <Hint />
      <UnderWay />
    </div>
  );
}

function UnderWay() {
  const { explorer, actions } = useApp();
  const { explorer: explore } = actions;
  const running = explorer.progress.value;
  const judging = explorer.scores.progress.value;
  const doing = running ?? judging;
  if (!doing) return null;
  const said = !running ? strings.judging : running.what === 'redraw' ? strings.redrawing : strings.inventing;
  const label = said({ done: doing.done, total: doing.total });
  return (
    <div class="under-way">
      <span class="count">{label}</span>
      <progress class="progress" aria-label={label} value={doing.done} max={doing.total} />
      <ActionButton action={running ? explore.stop : explore.stopJudging} class="button small" text />
    </div>
  );
}

/** The state of the combination, its result, or the number of styles. */
function Hint() {
  const { explorer, actions } = useApp();
  const { parent, lastParents, unsorted } = explorer;
  const [shown, all] = [explorer.shown.value.length, explorer.items.value.length];
  if (parent.value) {
    return (
      <p class="explorer-hint">
        {strings.breedWith({ name: parent.value.name })}
        <ActionButton action={actions.explorer.cancelCombining} class="button small" text />
      </p>
    );
  }
  if (lastParents.value) {
    const [a, b] = lastParents.value;
    return (
      <p class="explorer-hint">
        {a.name === b.name ? strings.litterOfOne({ a: a.name }) : strings.litterOf({ a: a.name, b: b.name })}
      </p>
    );
  }
  if (unsorted.value && !explorer.scores.progress.value) return <p class="explorer-hint">{strings.sortAgain}</p>;
  if (all === 0) return null;
  return (
    <p class="count" title={strings.dropped({ n: explorer.dropped.value })}>
      {shown === all ? strings.stylesShown({ all }) : strings.stylesShownOf({ shown, all })}
    </p>
  );
}
