// @ts-check
/** Words of pages that carry their project, and of what files say beside their pixels. */

const photos = (/** @type {number} */ n) => (n === 1 ? '1 photo' : `${n} photos`);

/** @param {readonly string[]} names @returns {string} some of them, and how many more */
export function some(names) {
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
  photosUnclean: (/** @type {number} */ n) => `${photos(n)} in it may still say where and when: Inkpanel cannot take that out of files of that kind.`,

  noProjectInside: 'it is a picture without project data.',
  pageOpened: (/** @type {string} */ name) => `${name} is open again, as a project of its own.`,
  photosMissing: (/** @type {string} */ name, /** @type {number} */ n, /** @type {number} */ of) => (
    `${name} is open, but ${n === of ? (of === 1 ? 'its photo is' : `its ${of} photos are`) : `${n} of its ${of} photos ${n === 1 ? 'is' : 'are'}`} not on this device. Choose or drop ${n === 1 ? 'it' : 'them'}: each goes back to its place.`
  ),
  photosBack: (/** @type {number} */ n) => `${photos(n)} ${n === 1 ? 'is' : 'are'} back in place.`,
  photosStillMissing: (/** @type {number} */ n) => `${photos(n)} of this page ${n === 1 ? 'is' : 'are'} still missing. Choose or drop ${n === 1 ? 'it' : 'them'}: each goes back to its place.`,
  absentPhoto: (/** @type {number} */ n) => `Missing photo ${n}`,
  choosePhotos: 'Choose photos',
  useAsPhoto: 'Use as a photo',
  backTo: (/** @type {string} */ name) => `Back to ${name}`,

  projectSaved: (/** @type {readonly string[]} */ unclean) => (
    unclean.length === 0
      ? 'The project was saved as a file, with your photos at full size, but without their place, date and camera.'
      : `The project was saved as a file, with your photos at full size. ${some(unclean)} may still say where and when: Inkpanel cannot take that out of files of that kind.`
  ),
};
