/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Style from a picture',
  styleFromPictureHelp: 'Applies the look of a comic page, a print or a painting to your photos',
  imitationAbout:
    'Choose a picture with the look that you want: a comic page, a print, a drawing or a painting. Within a few seconds, Inkpanel finds styles that give your photo this look. The picture stays on this device.',
  imitationDropHere: 'Or drop a picture here.',
  imitationChoose: 'Choose a picture',
  imitationOther: 'Another picture',
  imitationFile: 'Picture with the style that you want',
  imitationAgain: 'Search again',
  imitationAnyway: 'Search anyway',
  imitating: 'Searching for styles…',
  imitationProposals: 'Styles found',
  imitationPhotos: 'Photo for the preview',
  imitationNone: 'No style is close to this picture. Try another one.',
  imitationNeedsPhotos: 'Choose photos first: Inkpanel shows the styles on one of them.',
  dropForStyle: 'Drop here, or anywhere with Alt, to copy the style of a picture',
  imitationFound: (n: number) =>
    n === 1
      ? '1 style found. Use, edit or save it to keep it.'
      : `${n} styles found. Use, edit or save one to keep it.`,
  imitationName: (picture: string, place: number) => `Like ${picture} ${place}`,
  imitationPictureOf: (name: string) => `The picture ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'This picture is too small. Each side needs at least 64 pixels.',
    'blank-picture': 'This picture is blank, so it has no style.',
    'plain-photo':
      'This looks like a plain photo without lines, inks or paint. Choose a drawing, a print or a painting.',
    'imitation-missing': 'The style search could not be loaded. Check your connection and try again.',
    'worker-lost': 'Inkpanel crashed while reading this picture. Try another one.',
    'unreadable-file': 'The file was moved, changed or deleted since you chose it.',
    'unknown-format': 'This is not a readable image. Choose a JPEG, PNG, WebP, AVIF, GIF, BMP or TIFF file.',
    damaged: 'The file of this picture is damaged or truncated.',
    'too-large': 'This picture is too large.',
  } as Record<string, string>,
};
