/** The list of keys. */

export const keyStrings = {
  letterKeys: 'Single letters are shortcuts',
  keyList: [
    { keys: ['Space'], does: 'Shuffle' },
    { keys: ['L'], does: 'Shuffle layout' },
    { keys: ['S'], does: 'Shuffle style' },
    { keys: ['P'], does: 'Shuffle photos' },
    { keys: ['Ctrl', 'Z'], does: 'Undo' },
    { keys: ['Shift', 'Ctrl', 'Z'], does: 'Redo' },
    { keys: ['←', '↑', '→', '↓'], does: 'Move between panels' },
    { keys: ['Page Up', 'Page Down'], does: 'Go between the pages of the storyboard' },
    { keys: ['Enter'], does: 'Move a panel’s photo with the arrows' },
    { keys: [',', '.'], does: 'Earlier or later frame of a video, with Shift by a second' },
    { keys: ['+', '−', '0'], does: 'Zoom a panel’s photo, reset it' },
    { keys: ['Shift', 'Enter'], does: 'Select a panel' },
    { keys: ['Alt', '↑', '↓'], does: 'Slant a cut of the layout' },
    { keys: ['Ctrl', 'S'], does: 'Download PNG' },
    { keys: ['?'], does: 'This list' },
  ],
};
