/**
 * The layouts as thumbnails, filtered by family and number of panels. The list has custom layouts and the built-in
 * layouts that are good for the page. If the layout of the page is in neither list, it comes first.
 */

import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { LayoutPicture } from './layout-picture.tsx';
import { Listbox } from '../ui/listbox.tsx';
import { freshSeed } from '../document/pages.ts';
import { usePageGlimpse } from '../ui/glimpse.tsx';
import type { LayoutEntry, Template } from '../engine/types.ts';

/** The filter for custom layouts. The core's families are lower case. */
const MINE = 'Mine';

export function LayoutsList() {
  const { store, pages } = useApp();
  const family = useSignal('');
  const { panels, settings } = store.project.value;
  const layouts = store.layouts.value;
  const aspect = settings.width / settings.height;
  const current = useCurrent(layouts);
  // The same drawing is handed over each time, so that a shuffle does not compare hundreds of shapes.
  const pictures = useMemo(
    () =>
      new Map(layouts.map((layout) => [layout.id, <LayoutPicture key={layout.id} layout={layout} aspect={aspect} />])),
    [layouts, aspect],
  );
  const own = layouts.filter((layout) => layout.own !== null);
  const families = [...new Set(layouts.filter((layout) => layout.own === null).map((layout) => layout.family))];
  const counts = [...new Set(layouts.map((layout) => layout.count))].sort((a, b) => a - b);
  const filter = own.length === 0 && family.value === MINE ? '' : family.value;
  const shown = layouts.filter(
    (layout) =>
      (filter === '' || layout.family === filter || (filter === MINE && layout.own !== null)) &&
      (panels === null || layout.count === panels),
  );
  const groups = [
    { name: strings.thisPage, options: current ? [current] : [] },
    { name: strings.myLayouts, options: shown.filter((layout) => layout.own !== null) },
    {
      name: own.length > 0 || current ? strings.allLayouts : '',
      options: shown.filter((layout) => layout.own === null),
    },
  ];

  const glimpse = usePageGlimpse((id) =>
    id === current?.id ? null : pages.preview({ type: 'choose-layout', layout: layoutOf(id), seed: freshSeed() }),
  );

  /** The layout in page data: a complete custom layout, or the id of a built-in one. */
  function layoutOf(id: string): string | Template {
    const own = layouts.find((layout) => layout.id === id)?.own ?? null;
    return own === null ? id : store.own.value[own];
  }

  function choose(id: string) {
    if (id !== current?.id) pages.chooseLayout(layoutOf(id));
  }

  return (
    <>
      <div class="filters">
        <select
          class="select"
          aria-label={strings.family}
          value={filter}
          onChange={(event) => {
            family.value = event.currentTarget.value;
          }}
        >
          <option value="">{strings.anyFamily}</option>
          {own.length > 0 && <option value={MINE}>{strings.myLayouts}</option>}
          {families.map((name) => (
            <option key={name} value={name}>
              {strings.familyName(name)}
            </option>
          ))}
        </select>
        <select
          class="select"
          aria-label={strings.panels}
          value={panels ?? ''}
          onChange={(event) =>
            pages.wantPanels(event.currentTarget.value === '' ? null : Number(event.currentTarget.value))
          }
        >
          <option value="">{strings.anyPanels}</option>
          {counts.map((count) => (
            <option key={count} value={count}>
              {strings.panelCount({ n: count })}
            </option>
          ))}
        </select>
      </div>
      <Listbox
        label={strings.layouts}
        class="layouts-list"
        groups={groups}
        selected={store.layoutFacts.value?.id ?? null}
        onChoose={choose}
        onPoint={glimpse.point}
        names
        nameOf={strings.layoutTitle}
        tileOf={strings.layoutTile}
        noteOf={({ count }) => strings.panelCount({ n: count })}
        empty={strings.noLayouts}
        picture={(layout) => pictures.get(layout.id) ?? <LayoutPicture layout={layout} aspect={aspect} />}
      />
      {glimpse.view}
    </>
  );
}

/** The layout of the page if it is not in the list: a random layout, or a manually changed one. */
function useCurrent(layouts: readonly LayoutEntry[]): LayoutEntry | null {
  const { store } = useApp();
  const layout = store.page.value?.layout;
  const { width, height } = store.project.value.settings;
  const planner = store.planner.value;
  const listed = typeof layout !== 'object' || layouts.some(({ id }) => id === layout.id);
  return useMemo(() => {
    if (listed || !planner) return null;
    const own = [layout as Template];
    return planner.listLayouts({ page: { width, height }, own })[0];
  }, [listed, layout, planner, width, height]);
}
