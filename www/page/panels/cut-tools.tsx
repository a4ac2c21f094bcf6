/** The chosen cut of the layout, moved and slanted by clicks: what a drag and the arrows do too. */

import { strings } from '../../strings/strings.ts';
import { useApp } from '../../app/context.ts';
import { Tool } from './panel-tools.tsx';

/** What a click moves by, in parts of the cell that is cut. */
const STEP = 0.02;

export function CutTools() {
  const { store, reshaping } = useApp();
  const at = reshaping.cut.value;
  const cut = store.layoutFacts.value?.cuts[at ?? -1];
  const why = cut ? '' : strings.selectCut;
  const rows = cut?.axis === 'rows';

  function move(by: number, slant: number) {
    if (cut && at !== null)
      reshaping.moveCut(at, { fraction: cut.fraction + by, slant: cut.slant + slant }, `cut-clicks-${at}`);
  }

  return (
    <>
      <span class="rail-line" />
      <Tool icon={rows ? 'up' : 'previous'} label={strings.cutBack} why={why} onClick={() => move(-STEP, 0)} />
      <Tool icon={rows ? 'down' : 'next'} label={strings.cutForth} why={why} onClick={() => move(STEP, 0)} />
      <Tool icon="slantLess" label={strings.slantBack} why={why} onClick={() => move(0, -2 * STEP)} />
      <Tool icon="slantMore" label={strings.slantForth} why={why} onClick={() => move(0, 2 * STEP)} />
    </>
  );
}
