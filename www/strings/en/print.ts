/** Strings of print: sheets, bleed, spot-colour separations, and the resolution check. */

export const printStrings = {
  print: {
    moreSizes: 'More sizes',
    purpose: {
      paper: 'Paper',
      book: 'Books',
      screen: 'Screens',
    },
    showSafe: 'Show safe area',
    safeHelp: 'Anything inside this line is safe from trimming. The line is not exported.',
    bleed: 'Bleed',
    bleeds: {
      none: 'None',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 in',
    },
    bleedHelp:
      'Panels at the page edge extend into the bleed, so that no white edge shows after trimming. With a margin, the bleed has the paper colour.',
    marks: 'Crop marks',
    sheets: 'Sheets',
    impositions: {
      none: 'One page per sheet',
      booklet: 'Booklet to fold and staple',
      zine: 'Mini-zine, eight pages from one sheet',
      twoUp: 'Two pages per sheet, to cut apart',
      spreads: 'Two-page spreads',
    },
    booklet: 'Print on both sides, flipped on the short edge. Fold once and staple through the fold.',
    zine: 'Print on one side. Fold into eighths, cut the middle along the fold, push together.',
    twoUp: 'Print, then cut between the pages.',
    spreads: 'A single first page, then pairs of facing pages as in an open book.',
    blanks: (n: number) => `${n === 1 ? 'One page stays' : `${n} pages stay`} empty.`,
    paperSize: 'Paper',
    papers: {
      none: 'Same size as the pages',
      a4: 'A4',
      a3: 'A3',
      letter: 'Letter',
      tabloid: 'Tabloid',
    },
    plates: 'Spot-colour separations (riso, screen print)',
    platesHelp: 'One gray PDF file per ink, together in a ZIP.',
    inks: {
      red: 'red',
      blue: 'blue',
      pink: 'pink',
      teal: 'teal',
      orange: 'orange',
      navy: 'navy',
      coral: 'coral',
      green: 'green',
      yellow: 'yellow',
      cyan: 'cyan',
      magenta: 'magenta',
      violet: 'violet',
      black: 'black',
    },
    coarse: (n: number, dpi: number) =>
      `${n === 1 ? 'One panel has' : `${n} panels have`} less than ${dpi} dpi at this size and may look soft in print:`,
    coarsePanel: (n: number, dpi: number) => `Panel ${n}: ${dpi} dpi`,
    coarseOn: (page: number, n: number, dpi: number) => `Page ${page}, panel ${n}: ${dpi} dpi`,
    coarseMore: (n: number) => `and ${n} more`,
    enlarge: 'Upscale low-resolution photos',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'The photo of this panel is upscaled with sharper edges. Upscaling adds no detail.'
        : `The photos of these ${n} panels are upscaled with sharper edges. Upscaling adds no detail.`,
    coarseMark: (dpi: number) => `${dpi} dpi`,
    coarseHelp: 'Show the photo smaller, crop less, or use a larger photo.',
    coarseHide: 'Hide resolution warnings',
  },
};
