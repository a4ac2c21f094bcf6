// @ts-check
/**
 * The layouts, drawn, with a filter by family and the wanted number of panels.
 */

import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { strings } from '../strings.js';
import { useApp } from './context.js';
import { LayoutPicture } from './layout-picture.jsx';
import { Listbox } from './listbox.jsx';

export function LayoutsList() {
  const { store, pages } = useApp();
  const family = useSignal('');
  const { panels, settings } = store.project.value;
  const layouts = store.suitable.value;
  const selected = store.page.value?.layout ?? null;
  const aspect = settings.width / settings.height;
  // The same drawing is handed over each time, so that a shuffle does not compare hundreds of shapes.
  const pictures = useMemo(
    () => new Map(layouts.map((layout) => [layout.id, <LayoutPicture key={layout.id} layout={layout} aspect={aspect} />])),
    [layouts, aspect],
  );
  const families = [...new Set(layouts.map((layout) => layout.family))];
  const counts = [...new Set(layouts.map((layout) => layout.count))].sort((a, b) => a - b);
  const shown = layouts.filter((layout) => (
    (family.value === '' || layout.family === family.value) && (panels === null || layout.count === panels)
  ));

  return (
    <>
      <div class="filters">
        <select
          class="select"
          aria-label={strings.family}
          value={family.value}
          onChange={(event) => { family.value = event.currentTarget.value; }}
        >
          <option value="">{strings.anyFamily}</option>
          {families.map((name) => <option key={name} value={name}>{strings.familyName(name)}</option>)}
        </select>
        <select
          class="select"
          aria-label={strings.panels}
          value={panels ?? ''}
          onChange={(event) => pages.wantPanels(event.currentTarget.value === '' ? null : Number(event.currentTarget.value))}
        >
          <option value="">{strings.anyPanels}</option>
          {counts.map((count) => <option key={count} value={count}>{strings.panelCount(count)}</option>)}
        </select>
      </div>
      <Listbox
        label={strings.layouts}
        class="layouts-list"
        groups={[{ name: '', options: shown }]}
        selected={typeof selected === 'string' ? selected : selected?.id ?? null}
        onChoose={pages.chooseLayout}
        empty={strings.noLayouts}
        picture={({ id }) => pictures.get(id)}
      />
    </>
  );
}
