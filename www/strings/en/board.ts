/** Words of the board: the page, the shuffling, the bars. */

export const boardStrings = {
  page: 'Storyboard page',
  panel: (n: number, of: number) => `Panel ${n} of ${of}`,
  shuffle: 'Shuffle',
  betterCrops: 'Better crops found',
  betterCropsWhy: 'Faces and objects were found since: show them whole',
  shufflePart: { layout: 'Shuffle layout', style: 'Shuffle style', photos: 'Shuffle photos' },
  lockPart: { layout: 'Lock layout', style: 'Lock style', photos: 'Lock photos' },
  part: { layout: 'Layout', style: 'Style', photos: 'Photos' },
  undo: 'Undo',
  redo: 'Redo',
  previous: 'Previous page',
  next: 'Next page',
  download: 'Download PNG',
  export: 'Export',
  theme: { light: 'Use the light theme', dark: 'Use the dark theme' },
  keys: 'Keyboard shortcuts',
  close: 'Close',
  cancel: 'Cancel',
  dismiss: 'Dismiss',
};
