/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Style from a picture',
  styleFromPictureHelp: 'Takes the look of a picture, a comic page, a print or a painting, over to your photos',
  imitationAbout:
    'Choose a picture whose look you want: a comic page, a print, a drawing, a painting. Styles that give your own photo this look are searched for in a few seconds. The picture stays on this device.',
  imitationDrop: 'You can also drop a picture anywhere with Alt held.',
  imitationChoose: 'Choose a picture',
  imitationOther: 'Another picture',
  imitationFile: 'Picture whose style is wanted',
  imitationAgain: 'Search again',
  imitationAnyway: 'Search anyway',
  imitating: 'Searching for styles…',
  imitationProposals: 'Styles found',
  imitationPhotos: 'Photo to try them on',
  imitationNone: 'No style came near this picture. Try another one.',
  imitationNeedsPhotos: 'Choose photos first: the style of a picture is tried on one of them.',
  dropForStyle: 'Drop here, or with Alt held, to take over the style of a picture',
  imitationFound: (n: number) =>
    n === 1
      ? '1 style found. It is yours when you use, edit or save it.'
      : `${n} styles found. One is yours when you use, edit or save it.`,
  imitationName: (picture: string, place: number) => `Like ${picture} ${place}`,
  imitationPictureOf: (name: string) => `The picture ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'This picture is too small to read a style from: each side needs 64 pixels.',
    'blank-picture': 'This picture is blank: there is no style in it.',
    'plain-photo':
      'This looks like a plain photo: there are no lines, inks or paints to take over. Choose a drawing, a print or a painting.',
    'imitation-missing': 'What finds styles in pictures could not be loaded. Try again with a connection.',
    'worker-lost': 'Reading this picture stopped the program. Try another one.',
    'unreadable-file': 'The file was moved, changed or deleted since you chose it.',
    'unknown-format': 'This is no picture that can be read. Choose a JPEG, PNG, WebP, AVIF, GIF, BMP or TIFF file.',
    damaged: 'The file of this picture is damaged or cut short.',
    'too-large': 'This picture is too large.',
  } as Record<string, string>,
};
