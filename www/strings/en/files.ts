/** Strings of files with an embedded project, and of archives. */

export const fileStrings = {
  cargoFile: 'Inside the file',
  cargoFileHelp: {
    project: 'Drop the file here to edit it again. It finds its photos on this device.',
    photos: 'Includes your original photos, so it opens on any device. Anyone with the file can see them.',
    none: 'Only the pages.',
  },
  packingPhotos: (percent: string) => `Adding the photos to the file, ${percent}`,
  photosTooLarge: 'together, the photos are too large for a PNG. Save the project as a file instead.',
  savingProject: (done: number, total: number) => `Saving the project, ${Math.floor(done)} of ${total} files`,
  damagedInArchive: (archive: string) => `it is damaged in ${archive}.`,
  noPicturesInside: 'it contains no images.',
  unknownJson: 'it is not an Inkpanel layout or style.',
};
