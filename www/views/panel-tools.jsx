// @ts-check
/**
 * What can be done with panels, in a rail beside the page, or below it where there is no room: what is chosen is
 * changed. A tool that cannot be used says why.
 */

import { strings } from '../strings.js';
import { useApp } from './context.js';
import { Icon } from './icon.jsx';

export function PanelTools() {
  const { store, selection, merging, reshaping } = useApp();
  const facts = store.layoutFacts.value;
  const chosen = selection.panels.value;
  const editing = reshaping.editing.value;
  if (!facts) return null;
  const [panel] = chosen;
  const fixed = oneOf(chosen) || (facts.editable && panel < facts.base ? '' : strings.noCuts);
  const bare = oneOf(chosen) || (panel < facts.base && (!facts.editable || facts.base === 1) ? strings.notRemoved(facts.editable) : '');
  return (
    <div class="rail" role="group" aria-label={strings.panelTools}>
      <Tool icon="select" label={strings.selectPanels} pressed={selection.several.value}
        onClick={() => selection.choose(!selection.several.value)} />
      <Tool icon="merge" label={strings.merge} why={merging.cannotMerge()} onClick={merging.merge} />
      <Tool icon="split" label={strings.split} why={merging.cannotSplit()} onClick={merging.split} />
      {editing && (
        <>
          <span class="rail-line" />
          <Tool icon="rows" label={strings.splitRows} why={fixed} onClick={() => reshaping.splitPanel(panel, 'rows')} />
          <Tool icon="columns" label={strings.splitColumns} why={fixed} onClick={() => reshaping.splitPanel(panel, 'columns')} />
          <Tool icon="bin" label={strings.removePanel} why={bare} onClick={() => reshaping.removePanel(panel)} />
          <Tool icon="check" label={strings.doneEditing} onClick={() => { reshaping.editing.value = false; }} />
        </>
      )}
      <span class="visually-hidden" role="status">{chosen.length > 0 ? strings.chosenPanels(chosen.length) : ''}</span>
    </div>
  );
}

/** @param {readonly number[]} chosen */
function oneOf(chosen) {
  return chosen.length === 1 ? '' : strings.selectOne;
}

/**
 * @param {{ icon: string, label: string, onClick: () => void, why?: string, pressed?: boolean }} props
 *   `why`: the reason that it cannot be used
 */
export function Tool({ icon, label, onClick, why = '', pressed }) {
  return (
    <button
      type="button"
      class="icon-button tool"
      aria-label={label}
      aria-pressed={pressed}
      title={why ? `${label}: ${why}` : label}
      disabled={why !== ''}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
