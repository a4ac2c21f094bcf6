/**
 * What can be done with panels, in a rail beside the page, or below it where there is no room: what is chosen is
 * changed. A tool that cannot be used says why.
 */

import { STEP } from '../../photos/scrubbing.ts';
import { strings } from '../../strings/strings.ts';
import { useApp } from '../../app/context.ts';
import { CutTools } from './cut-tools.tsx';
import { Icon } from '../../ui/icon.tsx';

export function PanelTools() {
  const { store, selection, merging, reshaping } = useApp();
  const facts = store.layoutFacts.value;
  const chosen = selection.panels.value;
  const editing = reshaping.editing.value;
  if (!facts) return null;
  const [panel] = chosen;
  const fixed = oneOf(chosen) || (facts.editable && panel < facts.base ? '' : strings.noCuts);
  const bare =
    oneOf(chosen) ||
    (panel < facts.base && (!facts.editable || facts.base === 1) ? strings.notRemoved(facts.editable) : '');
  return (
    <div class="rail" role="group" aria-label={strings.panelTools}>
      <Tool
        icon="select"
        label={strings.selectPanels}
        pressed={selection.several.value}
        onClick={() => selection.choose(!selection.several.value)}
      />
      <Tool icon="merge" label={strings.merge} why={merging.cannotMerge()} onClick={merging.merge} />
      <Tool icon="split" label={strings.split} why={merging.cannotSplit()} onClick={merging.split} />
      {!editing && chosen.length > 0 && <PhotoTools />}
      {editing && (
        <>
          <span class="rail-line" />
          <Tool icon="rows" label={strings.splitRows} why={fixed} onClick={() => reshaping.splitPanel(panel, 'rows')} />
          <Tool
            icon="columns"
            label={strings.splitColumns}
            why={fixed}
            onClick={() => reshaping.splitPanel(panel, 'columns')}
          />
          <Tool icon="bin" label={strings.removePanel} why={bare} onClick={() => reshaping.removePanel(panel)} />
          {facts.cuts.length > 0 && <CutTools />}
          <span class="rail-line" />
          <Tool
            icon="check"
            label={strings.doneEditing}
            onClick={() => {
              reshaping.editing.value = false;
            }}
          />
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
  const { store, selection, framing, scrubbing, download } = useApp();
  const chosen = selection.panels.value;
  const [panel, other] = chosen;
  const frame = chosen.length === 1 && scrubbing.isFrame(panel);
  const mode = framing.mode.value?.kind;
  const one = oneOf(chosen);
  const held = chosen.some(framing.isLocked) ? strings.panelLocked : '';
  const why = one || held;
  const edited = store.page.value?.panels[panel]?.edited;
  const swap = () => (other === undefined ? framing.toggle('swap', panel) : framing.swap(panel, other));
  const scrub = (seconds: number) => scrubbing.nudge(panel, seconds, `scrub-${panel}`);
  return (
    <>
      <span class="rail-line" />
      <Tool icon="zoomIn" label={strings.zoomIn} why={why} onClick={() => framing.closer(panel, 1.2)} />
      <Tool icon="zoomOut" label={strings.zoomOut} why={why} onClick={() => framing.closer(panel, 1 / 1.2)} />
      <Tool icon="fit" label={strings.fitSubject} why={why} onClick={() => framing.fit(panel)} />
      <Tool
        icon="reset"
        label={strings.resetCrop}
        why={why || (edited ? '' : strings.unchanged)}
        onClick={() => framing.reset(panel)}
      />
      <Tool
        icon="swap"
        label={strings.swapPhoto}
        why={chosen.length > 2 ? one : held}
        pressed={mode === 'swap'}
        onClick={swap}
      />
      <Tool
        icon="focus"
        label={strings.focusPoint}
        why={why}
        pressed={mode === 'focus'}
        onClick={() => framing.toggle('focus', panel)}
      />
      <Tool
        icon={framing.isLocked(panel) ? 'lock' : 'unlock'}
        label={strings.lockPanel}
        why={one}
        pressed={framing.isLocked(panel)}
        onClick={() => framing.lock(panel, !framing.isLocked(panel))}
      />
      <Tool
        icon="save"
        label={strings.savePanel}
        why={one || (store.page.value?.panels[panel]?.photo ? '' : strings.noPhotoHere)}
        onClick={() => download.savePanel(panel)}
      />
      {frame && (
        <>
          <span class="rail-line" />
          <Tool icon="earlier" label={strings.earlierFrame} shortcut="," why={held} onClick={() => scrub(-STEP)} />
          <Tool icon="later" label={strings.laterFrame} shortcut="." why={held} onClick={() => scrub(STEP)} />
        </>
      )}
    </>
  );
}

function oneOf(chosen: readonly number[]) {
  return chosen.length === 1 ? '' : strings.selectOne;
}

/** @param props `why`: the reason that it cannot be used */
export function Tool({
  icon,
  label,
  onClick,
  why = '',
  pressed,
  shortcut,
}: {
  icon: string;
  label: string;
  onClick: () => void;
  why?: string;
  pressed?: boolean;
  shortcut?: string;
}) {
  const name = shortcut ? `${label} (${shortcut})` : label;
  return (
    <button
      type="button"
      class="icon-button tool"
      aria-label={label}
      aria-pressed={pressed}
      aria-keyshortcuts={shortcut}
      title={why ? `${name}: ${why}` : name}
      disabled={why !== ''}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
