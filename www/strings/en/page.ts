/** Words of the page settings. */

export const pageStrings = {
  pageSettings: 'Page settings',
  pageSize: 'Page size',
  gutter: 'Gutter',
  margin: 'Margin',
  border: 'Border',
  cornerRadius: 'Corner radius',
  paper: 'Paper colour',
  borderColor: 'Border colour',
  size: {
    a4: 'A4',
    'a4-landscape': 'A4 landscape',
    letter: 'Letter',
    square: 'Square',
    wide: 'Screen 16:9',
    story: 'Story 9:16',
    portrait: 'Portrait 4:5',
    webtoon: 'Webtoon',
    custom: 'Custom',
  },

  customSize: { width: 'Width', height: 'Height', dpi: 'Dots an inch', unit: 'Unit' },
  units: { px: 'pixels', mm: 'mm', in: 'inches' },
  wrongSize: {
    side: 'A side must be from 64 to 14,000 pixels.',
    pixels: 'The page must have at most 72 million pixels.',
    dpi: 'Dots an inch must be from 36 to 1200.',
  },
};
