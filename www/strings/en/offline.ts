/** Words of what the page does as a program of this device: updates, installing, files from other programs. */

export const offlineStrings = {
  newVersion: 'A new version is ready.',
  reload: 'Reload',
  notReloaded: 'The page was not loaded again, as your work is not saved.',
  install: 'Install',
  installHelp: 'Opens Inkpanel in a window of its own, also without a connection',
  sharedLost: 'What was shared did not arrive: the storage of this browser may be full. Add the photos here instead.',
  launchFailed: (name: string) => `${name} could not be opened. Add it here instead.`,
  noDetectorOffline:
    'Without a connection faces cannot be found yet, so photos are cropped by contrast until you are online.',
};
