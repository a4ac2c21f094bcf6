/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'Inside the file',
  cargoFileHelp: {
    project: 'Drop the file here to work on it again. It finds its photos on this device.',
    photos: 'Opens on any device, photos and all. Whoever has the file has them.',
    none: 'The pages and nothing else.',
  },
  packingPhotos: (percent: string) => `Putting the photos in, ${percent}`,
  photosTooLarge: 'together the photos are too large for a PNG. Save the project as a file instead.',
  savingProject: (done: number, total: number) => `Saving the project, ${Math.floor(done)} of ${total} files`,
  damagedInArchive: (archive: string) => `it is damaged in ${archive}.`,
  noPicturesInside: 'there is no picture in it.',
  unknownJson: 'it is neither a layout nor a style of Inkpanel.',
};
