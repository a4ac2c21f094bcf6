/** Words of the start, and of things that take files in. */

export const startStrings = {
  lead: ['Drop your photos.', 'Get a comic page.'],
  leadTouch: ['Pick your photos.', 'Get a comic page.'],
  leadMore: 'Inkpanel picks, crops, inks and lays them out. Shuffle until you love it.',
  chooseFiles: 'Choose photos or a video',
  filesLabel: 'Photos or video',
  trySamples: 'Try the sample album',
  startPages: 'Three comic pages made from the sample album',
  recentProjects: 'Recent projects',
  privacy: 'Nothing leaves this device.',
  dropHere: 'Drop to add your photos',
  framed: 'Inkpanel does not run inside other websites, to protect you from clickjacking.',
  openInTab: 'Open Inkpanel in a new tab',
  starting: 'Starting Inkpanel',
};
