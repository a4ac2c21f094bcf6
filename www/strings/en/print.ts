/** Words of what is printed: sheets, bleed, plates, and the check before it. */

export const printStrings = {
  print: {
    moreSizes: 'More sizes',
    purpose: {
      paper: 'Paper',
      book: 'Books',
      screen: 'Screens',
    },
    showSafe: 'Show safe area',
    safeHelp: 'Faces and words inside of the line are never cut off. It is in no file.',
    bleed: 'Bleed',
    bleeds: {
      none: 'None',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 in',
    },
    bleedHelp:
      'Panels at the edge go on beyond it, so that no white shows where the page is cut. With a margin there is paper colour there.',
    marks: 'Cut marks',
    sheets: 'Sheets',
    impositions: {
      none: 'One page each',
      booklet: 'Booklet to fold and staple',
      zine: 'Mini-zine, eight pages from one sheet',
      twoUp: 'Two pages to cut apart',
      spreads: 'Spreads of two pages',
    },
    booklet: 'Print on both sides, flipped on the short edge. Fold once and staple through the fold.',
    zine: 'Print on one side. Fold in eighths, cut the middle along the fold, push together.',
    twoUp: 'Print, then cut between the pages.',
    spreads: 'The first page alone, then two and two as an open book shows them.',
    blanks: (n: number) => `${n === 1 ? 'One page stays' : `${n} pages stay`} empty.`,
    paperSize: 'Paper',
    papers: {
      none: 'As large as the pages',
      a4: 'A4',
      a3: 'A3',
      letter: 'Letter',
      tabloid: 'Tabloid',
    },
    plates: 'Plates for riso or screen print',
    platesHelp: 'A gray PDF file for each ink, together in a ZIP.',
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
    enlarge: 'Enlarge well',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'The photo of this panel is enlarged with sharper edges. It gains no detail that it does not have.'
        : `The photos of these ${n} panels are enlarged with sharper edges. They gain no detail that they do not have.`,
    coarseMark: (dpi: number) => `${dpi} dpi`,
    coarseHelp: 'Show the photo smaller or with less cropped off, or take a larger one.',
    coarseHide: 'Hide the marks',
  },
};
