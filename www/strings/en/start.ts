/** Words of the start, and of things that take files in. */

export const startStrings = {
  lead: ['Drop your photos.', 'Get a comic page.'],
  leadMore: 'Inkpanel picks, crops, inks and lays them out. Shuffle until you love it.',
  chooseFiles: 'Choose photos or a video',
  filesLabel: 'Photos or video',
  trySamples: 'Try the sample album',
  privacy: 'Nothing leaves this device.',
  dropHere: 'Drop to add your photos',
  framed:
    'Another site shows Inkpanel inside its own page. There it does not work, so that nobody can make you press what you do not see.',
  openInTab: 'Open Inkpanel in a tab of its own',
  starting: 'Getting the ink ready',
};
