/** Strings of files with an embedded project, and of photo metadata. */

const photos = (n: number) => (n === 1 ? '1 photo' : `${n} photos`);

/** @returns some of the names, and the number of the others */
export function some(names: readonly string[]): string {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} and ${rest} more` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Inside the PNG',
  cargoKind: { project: 'With project data', photos: 'With photos', none: 'Without project data' },
  cargoHelp: {
    project: 'Drop the PNG here to edit it again. It finds its photos on this device.',
    photos: 'Includes your original photos, so it opens on any device. Anyone with the file can see them.',
    none: 'Only the image.',
  },
  cargoClean: 'The file never contains the place, date or camera of your photos.',
  photosUnclean: (n: number) =>
    `${photos(n)} in it may still contain place and date, because Inkpanel cannot clean this file format.`,

  noProjectInside: 'it is an image without project data.',
  pageOpened: (name: string) => `${name} was opened as a separate project.`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name} is open, but ${n === of ? (of === 1 ? 'its photo is' : `its ${of} photos are`) : `${n} of its ${of} photos ${n === 1 ? 'is' : 'are'}`} not on this device. Choose or drop ${n === 1 ? 'it' : 'them'} to restore ${n === 1 ? 'it' : 'them'}.`,
  photosBack: (n: number) => `${photos(n)} ${n === 1 ? 'was' : 'were'} restored.`,
  photosStillMissing: (n: number) =>
    `${photos(n)} of this page ${n === 1 ? 'is' : 'are'} still missing. Choose or drop ${n === 1 ? 'it' : 'them'} to restore ${n === 1 ? 'it' : 'them'}.`,
  absentPhoto: (n: number) => `Missing photo ${n}`,
  choosePhotos: 'Choose photos',
  openedAsPicture: (name: string) =>
    `${name} is a photo of this project now. The photos on that page are not on this device.`,
  openAsProject: 'Open as a project',
  useAsPhoto: 'Use as a photo',
  backTo: (name: string) => `Back to ${name}`,

  removeMetadata: 'Remove location and camera data',
  removeMetadataHelp: 'For files that you pass on. Dates are removed too, so new books cannot sort the photos by day.',
  /** @param unclean: files that kept their metadata; null if no metadata was removed */
  projectSaved: (unclean: readonly string[] | null) =>
    unclean === null
      ? 'The project was saved as a file, with your original photos. Their place, date and camera data are included.'
      : unclean.length === 0
        ? 'The project was saved as a file, with your photos at full size, but without their place, date and camera.'
        : `The project was saved as a file, with your photos at full size. ${some(unclean)} may still contain place and date, because Inkpanel cannot clean this file format.`,
};
