/** Keys, and the list of them. */

export const keyStrings = {
  letterKeys: 'Single letters are shortcuts',
  // As the keyboard calls them; what is called alike everywhere is not here.
  keyNames: { Ctrl: 'Ctrl', Space: 'Space', Shift: 'Shift', Enter: 'Enter', PageUp: 'Page Up', PageDown: 'Page Down' },
  // What the list says of keys that are no action with a name of its own.
  keyAbout: {
    walk: 'Move between panels',
    turn: 'Go between the pages of the storyboard',
    frame: 'Move a panel’s photo with the arrows',
    scrub: 'Earlier or later frame of a video, with Shift by a second',
    zoom: 'Zoom a panel’s photo, reset it',
    choose: 'Select a panel',
    slant: 'Slant a cut of the layout',
    list: 'This list',
  },
};
