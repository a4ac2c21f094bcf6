/**
 * What can be done with panels, in a rail beside the page, or below it where there is no room: what is chosen is
 * changed. A tool that cannot be used says why.
 */

import { strings } from '../../strings/strings.ts';
import { useApp } from '../../ui/context.ts';
import { ActionButton } from '../../ui/action-button.tsx';
import type { Action } from '../../ui/action.ts';

export function PanelTools() {
  const { store, selection, reshaping, actions } = useApp();
  const { panels } = actions;
  const facts = store.layoutFacts.value;
  const chosen = selection.panels.value;
  const editing = reshaping.editing.value;
  if (!facts) return null;
  return (
    <div class="rail" role="group" aria-label={strings.panelTools}>
      <Tools of={[panels.select, panels.merge, panels.split]} />
      {!editing && chosen.length > 0 && <PhotoTools />}
      {editing && (
        <>
          <span class="rail-line" />
          <Tools of={[panels.splitRows, panels.splitColumns, panels.remove]} />
          {facts.cuts.length > 0 && (
            <>
              <span class="rail-line" />
              <Tools of={[panels.cutBack, panels.cutForth, panels.slantBack, panels.slantForth]} />
            </>
          )}
          <span class="rail-line" />
          <Tools of={[panels.done]} />
        </>
      )}
      <span class="visually-hidden" aria-live="polite">
        {chosen.length > 0 ? strings.chosenPanels(chosen.length) : ''}
      </span>
    </div>
  );
}

/** For the photo of the panel that is chosen, or the photos of two. */
function PhotoTools() {
  const { selection, scrubbing, actions } = useApp();
  const { zoomIn, zoomOut, fit, reset, swap, focus, lock, save, earlier, later } = actions.panels;
  const [panel, ...others] = selection.panels.value;
  return (
    <>
      <span class="rail-line" />
      <Tools of={[zoomIn, zoomOut, fit, reset, swap, focus, lock, save]} />
      {others.length === 0 && scrubbing.isFrame(panel) && (
        <>
          <span class="rail-line" />
          <Tools of={[earlier, later]} />
        </>
      )}
    </>
  );
}

function Tools({ of }: { of: readonly Action[] }) {
  return of.map((action, i) => <ActionButton key={i} action={action} class="icon-button tool" />);
}
