// @ts-check
/** The words about panels. */

export const panelStrings = {
  panelTools: 'Tools for panels',
  selectPanels: 'Select panels',
  merge: 'Merge',
  split: 'Split',
  merging: {
    few: 'select two panels or more that touch',
    apart: 'these panels do not touch',
    overlay: 'panels that lie on top of others cannot be merged',
    already: 'these panels share one image already',
    none: 'no merged panels',
  },
  chosenPanel: 'selected',
  lockedPanel: 'locked',
  chosenPanels: (/** @type {number} */ n) => (n === 1 ? '1 panel selected' : `${n} panels selected`),
  selectOne: 'select one panel',
  splitRows: 'Split into rows',
  splitColumns: 'Split into columns',
  removePanel: 'Remove panel',
  /** @type {(editable: boolean) => string} */
  notRemoved: (editable) => (editable ? 'it is the only one' : 'this layout has no cuts'),
  noCuts: 'this layout has no cuts',
  doneEditing: 'Done',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  fitSubject: 'Fit subject',
  resetCrop: 'Reset',
  swapPhoto: 'Swap photo',
  lockPanel: 'Lock panel',
  focusPoint: 'Focus point',
  earlierFrame: 'Earlier frame',
  laterFrame: 'Later frame',
  panelLocked: 'the panel is locked',
  unchanged: 'the photo is as the page placed it',
  putHere: (/** @type {string} */ photo, /** @type {number} */ panel) => `Put ${photo} in panel ${panel}`,
  modes: {
    frame: 'Arrows move the photo, + and − zoom, 0 resets, Enter ends',
    swap: 'Choose the panel to swap with',
    focus: 'Click what matters, or use arrows and Enter',
  },
  cuts: 'Cuts of the layout',
  cut: (/** @type {number} */ n, /** @type {number} */ of) => `Cut ${n} of ${of}`,
  cutAt: (/** @type {number} */ at, /** @type {number} */ slant) => (
    Math.abs(slant) < 0.5 ? `${Math.round(at)} %` : `${Math.round(at)} %, slanted by ${Math.round(slant)} %`
  ),
  cutKeys: 'Arrows move it, with Alt they slant it',
};
