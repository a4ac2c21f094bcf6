/** Words of pages that carry their project, and of what files say beside their pixels. */

const photos = (n: number) => (n === 1 ? '1 photo' : `${n} photos`);

/** @returns some of them, and how many more */
export function some(names: readonly string[]): string {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} and ${rest} more` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Inside the PNG',
  cargoKind: { project: 'With project data', photos: 'With photos', none: 'Without project data' },
  cargoHelp: {
    project: 'Drop the PNG here to work on it again. It finds its photos on this device.',
    photos: 'Opens on any device, photos and all. Whoever has the file has them.',
    none: 'The picture and nothing else.',
  },
  cargoClean: 'Place, date and camera of your photos are never in it.',
  photosUnclean: (n: number) =>
    `${photos(n)} in it may still say where and when: Inkpanel cannot take that out of files of that kind.`,

  noProjectInside: 'it is a picture without project data.',
  pageOpened: (name: string) => `${name} is open again, as a project of its own.`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name} is open, but ${n === of ? (of === 1 ? 'its photo is' : `its ${of} photos are`) : `${n} of its ${of} photos ${n === 1 ? 'is' : 'are'}`} not on this device. Choose or drop ${n === 1 ? 'it' : 'them'}: each goes back to its place.`,
  photosBack: (n: number) => `${photos(n)} ${n === 1 ? 'is' : 'are'} back in place.`,
  photosStillMissing: (n: number) =>
    `${photos(n)} of this page ${n === 1 ? 'is' : 'are'} still missing. Choose or drop ${n === 1 ? 'it' : 'them'}: each goes back to its place.`,
  absentPhoto: (n: number) => `Missing photo ${n}`,
  choosePhotos: 'Choose photos',
  useAsPhoto: 'Use as a photo',
  backTo: (name: string) => `Back to ${name}`,

  projectSaved: (unclean: readonly string[]) =>
    unclean.length === 0
      ? 'The project was saved as a file, with your photos at full size, but without their place, date and camera.'
      : `The project was saved as a file, with your photos at full size. ${some(unclean)} may still say where and when: Inkpanel cannot take that out of files of that kind.`,
};
