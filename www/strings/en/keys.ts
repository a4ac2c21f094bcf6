/** Keys, and the list of them. */

export const keyStrings = {
  letterKeys: 'Single-letter shortcuts',
  // Labels of the keys. Keys with the same label in every language are missing.
  keyNames: { Ctrl: 'Ctrl', Space: 'Space', Shift: 'Shift', Enter: 'Enter', PageUp: 'Page Up', PageDown: 'Page Down' },
  // Descriptions of keys that belong to no named action.
  keyAbout: {
    walk: 'Move between panels',
    turn: 'Move between pages',
    frame: 'Move a panel’s photo with the arrows',
    scrub: 'Earlier or later frame of a video; with Shift, by one second',
    zoom: 'Zoom a panel’s photo, reset it',
    choose: 'Select a panel',
    slant: 'Slant a divider of the layout',
    sizeInset: 'Change the size of an inset',
    originals: 'Hold to see the original photos',
    list: 'This list',
  },
};
