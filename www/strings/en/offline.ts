/** Strings of the installed app: updates, installation, files from other programs. */

export const offlineStrings = {
  newVersion: 'A new version is ready.',
  reload: 'Reload',
  notReloaded: 'The app did not reload, because your work is not saved.',
  install: 'Install',
  installHelp: 'Opens Inkpanel in a separate window, also offline',
  sharedLost: 'The shared files did not arrive. Browser storage may be full. Add the photos here instead.',
  launchFailed: (name: string) => `${name} could not be opened. Add it here instead.`,
  noDetectorOffline:
    'Face detection needs to be downloaded once. Until you are online, photos are cropped by contrast.',
};
