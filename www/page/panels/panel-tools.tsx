/**
 * What can be done with panels, in a rail beside the page, or below it where there is no room: what is chosen is
 * changed. What is for the photo of a panel stands at the panel, where there is room. A tool that cannot be used says why.
 */

import { strings } from '../../strings/strings.ts';
import { useApp } from '../../ui/context.ts';
import { ActionButton } from '../../ui/action-button.tsx';
import type { Action } from '../../ui/action.ts';
import type { Geometry } from '../../engine/types.ts';

export function PanelTools() {
  const { store, selection, reshaping, actions, ui } = useApp();
  const { panels } = actions;
  const facts = store.layoutFacts.value;
  const chosen = selection.panels.value;
  const editing = reshaping.editing.value;
  if (!facts) return null;
  return (
    <div class="rail" role="group" aria-label={strings.panelTools}>
      {!editing && chosen.length > 0 && !ui.wide.value && (
        <>
          <PhotoTools text />
          <span class="rail-line" />
        </>
      )}
      <Tools of={[panels.select, panels.merge, panels.split, panels.join]} />
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

/**
 * The tools for the photo of the panel that was chosen first: beside the page at the panel's height, so that no other panel is
 * under them.
 */
export function PanelBar({ geometry }: { geometry: Geometry }) {
  const { store, selection, framing, reshaping, ui } = useApp();
  const [panel] = selection.panels.value;
  // Where the panel is changes with the page.
  const bounds = store.page.value && panel !== undefined ? framing.boundsOf(panel) : null;
  if (!bounds || !ui.wide.value || reshaping.editing.value) return null;
  const middle = (bounds.y + bounds.height / 2) / geometry.height;
  const stop = (event: Event) => event.stopPropagation();
  return (
    <div
      class="panel-bar"
      role="toolbar"
      aria-label={strings.photoTools}
      aria-orientation="vertical"
      style={{ '--middle': middle }}
      onClick={stop}
      onPointerDown={stop}
    >
      <PhotoTools text />
    </div>
  );
}

/** For the photo of the panel that is chosen, or the photos of two. */
function PhotoTools({ text = false }: { text?: boolean }) {
  const { selection, scrubbing, actions } = useApp();
  const { zoomIn, zoomOut, fit, reset, swap, star, focus, breakFrame, correct, lock, save, saveSubject } =
    actions.panels;
  const { earlier, later } = actions.panels;
  const [panel, ...others] = selection.panels.value;
  return (
    <>
      <Tools
        of={[zoomIn, zoomOut, fit, reset, swap, star, focus, breakFrame, correct, lock, save, saveSubject]}
        text={text}
      />
      {others.length === 0 && scrubbing.isFrame(panel) && (
        <>
          <span class="rail-line" />
          <Tools of={[earlier, later]} text={text} />
        </>
      )}
    </>
  );
}

function Tools({ of, text = false }: { of: readonly Action[]; text?: boolean }) {
  const look = text ? 'panel-bar-tool tool' : 'icon-button tool';
  return of.map((action, i) => <ActionButton key={i} action={action} class={look} text={text} />);
}
