// @ts-check
/**
 * Every word on the page, in one place. A translation is another object of this shape.
 */

import { designerStrings } from './strings-designer.js';
import { keepingStrings } from './strings-keeping.js';
import { panelStrings } from './strings-panels.js';
import { wordStrings } from './strings-words.js';

/**
 * @param {number} seconds
 * @returns {string} minutes and seconds, and hours where there are any: `1:02:03.4`
 */
function clock(seconds) {
  const tenths = Math.round(seconds * 10);
  const [hours, minutes, rest] = [Math.floor(tenths / 36_000), Math.floor(tenths / 600) % 60, (tenths % 600) / 10];
  const two = (/** @type {number} */ value, digits = 0) => value.toFixed(digits).padStart(digits ? 4 : 2, '0');
  return `${hours ? `${hours}:${two(minutes)}` : minutes}:${two(rest, 1)}`;
}

export const strings = {
  name: 'Inkpanel',
  title: (/** @type {string} */ page) => `${page} – Inkpanel`,

  // Start
  lead: ['Drop your photos.', 'Get a comic page.'],
  leadMore: 'Inkpanel picks, crops, inks and lays them out. Shuffle until you love it.',
  chooseFiles: 'Choose photos or a video',
  filesLabel: 'Photos or video',
  trySamples: 'Try the sample album',
  privacy: 'Nothing leaves this device.',
  dropHere: 'Drop to add your photos',
  starting: 'Getting the ink ready',

  // Board
  page: 'Storyboard page',
  panel: (/** @type {number} */ n, /** @type {number} */ of) => `Panel ${n} of ${of}`,
  shuffle: 'Shuffle',
  shufflePart: { layout: 'Shuffle layout', style: 'Shuffle style', photos: 'Shuffle photos' },
  lockPart: { layout: 'Lock layout', style: 'Lock style', photos: 'Lock photos' },
  part: { layout: 'Layout', style: 'Style', photos: 'Photos' },
  undo: 'Undo',
  redo: 'Redo',
  previous: 'Previous page',
  next: 'Next page',
  pageOf: (/** @type {number} */ n, /** @type {number} */ of) => `Page ${n} of ${of}`,
  download: 'Download PNG',
  export: 'Export',
  theme: { light: 'Use the light theme', dark: 'Use the dark theme' },
  keys: 'Keyboard shortcuts',
  close: 'Close',
  cancel: 'Cancel',
  dismiss: 'Dismiss',

  // Side
  look: 'Look of the page',
  drawer: 'Drawer',
  layouts: 'Layouts',
  styles: 'Styles',
  alternatives: 'Alternatives',
  alternative: (/** @type {number} */ n) => `Alternative ${n}`,
  alternativesWait: 'Other pages appear here',
  family: 'Family',
  /** Families are named by the data files. @param {string} id */
  familyName: (id) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll('-', ' '),
  anyFamily: 'All families',
  panels: 'Panels',
  anyPanels: 'Any number',
  panelCount: (/** @type {number} */ n) => (n === 1 ? '1 panel' : `${n} panels`),
  noLayouts: 'No layout of this kind.',
  myLayouts: 'My layouts',
  allLayouts: 'All layouts',
  thisPage: 'This page',
  surprise: 'Surprise layout',
  surpriseShort: 'Surprise',
  editLayout: 'Edit layout',
  saveLayout: 'Save layout',
  loadLayout: 'Load layout',
  layoutFile: 'Layout file',
  forgetLayout: 'Remove from My layouts',
  layoutSaved: 'The layout was saved, and is in My layouts.',
  layoutKept: 'The layout is in My layouts. Add photos to see it.',
  layoutTooLong: (/** @type {string} */ name) => `layout ${name}: file: is longer than 256 KB`,

  ...panelStrings, ...designerStrings, ...keepingStrings, ...wordStrings,
  otherStyles: 'More',
  more: 'More',

  // Photos
  photos: 'Photos',
  usePhoto: (/** @type {string} */ name) => `Use ${name}`,
  removePhoto: (/** @type {string} */ name) => `Remove ${name}`,
  addPhotos: 'Add photos',
  kept: 'On the table',
  setAside: 'Set aside',
  choice: 'Choice of photos',
  alike: 'Set aside look-alikes',
  alikeValue: (/** @type {number} */ bits) => (
    bits < 7 ? `${bits}, nearly identical` : bits < 11 ? `${bits}, the same picture` : bits < 14 ? `${bits}, much alike` : `${bits}, somewhat alike`
  ),
  alikeKept: (/** @type {number} */ kept, /** @type {number} */ all) => `${kept} of ${all} kept`,
  order: 'Order',
  orders: { time: 'By time taken', name: 'By file name' },
  stackOf: (/** @type {number} */ count) => `${count} alike`,
  openStack: (/** @type {number} */ count, /** @type {string} */ name) => `Show the ${count} photos like ${name}`,
  take: 'Take',
  takeInstead: (/** @type {string} */ name) => `Take ${name} instead`,
  /** @param {{ title: string, author: string, licence: string }} sample */
  credit: ({ title, author, licence }) => `${title}, by ${author} (${licence})`,
  photoCount: (/** @type {number} */ used, /** @type {number} */ all) => (used === all ? `${all}` : `${used} of ${all}`),
  reading: (/** @type {number} */ done, /** @type {number} */ total) => `Reading photos, ${done} of ${total}`,
  cancelReading: 'Stop reading',

  // Videos
  videos: 'Videos',
  /** @param {string} name @param {number} seconds */
  frameName: (name, seconds) => `${name}, ${clock(seconds)}`,
  videoFrames: (/** @type {number} */ count) => (count === 1 ? '1 frame' : `${count} frames`),
  clock,
  trimStart: 'Start',
  trimEnd: 'End',
  frames: 'Frames',
  takeFrames: 'Take these frames',

  showSubjects: 'Show subjects',
  finding: (/** @type {number} */ done, /** @type {number} */ total) => `Faces ${done}/${total}`,
  findingLong: (/** @type {number} */ done, /** @type {number} */ total) => `Looking for faces and objects: ${done} of ${total} photos`,
  noDetector: 'Faces cannot be found here, so photos are cropped by contrast.',

  // Page settings
  pageSettings: 'Page settings',
  pageSize: 'Page size',
  gutter: 'Gutter',
  margin: 'Margin',
  border: 'Border',
  cornerRadius: 'Corner radius',
  paper: 'Paper colour',
  borderColor: 'Border colour',
  percent: (/** @type {number} */ value) => `${value.toFixed(1)} %`,
  size: {
    a4: 'A4', 'a4-landscape': 'A4 landscape', letter: 'Letter', square: 'Square', wide: 'Screen 16:9', story: 'Story 9:16',
    portrait: 'Portrait 4:5', webtoon: 'Webtoon', custom: 'Custom',
  },

  customSize: { width: 'Width', height: 'Height', dpi: 'Dots an inch', unit: 'Unit' },
  units: { px: 'pixels', mm: 'mm', in: 'inches' },
  wrongSize: {
    side: 'A side must be from 64 to 14,000 pixels.',
    pixels: 'The page must have at most 72 million pixels.',
    dpi: 'Dots an inch must be from 36 to 1200.',
  },

  // Export
  exportPage: 'Export the page',
  resolution: 'Quality',
  full: (/** @type {number} */ dpi) => (dpi >= 150 ? `Print, ${dpi} dpi` : 'Full size'),
  half: 'Half, for the web',
  format: 'Format',
  png: 'PNG, lossless',
  pixels: (/** @type {number} */ w, /** @type {number} */ h) => `${w} × ${h} pixels`,
  save: 'Save the file',
  exporting: (/** @type {number} */ percent) => `Drawing the page at full size, ${percent} %`,
  saved: 'The page was saved.',

  // Keys
  keyList: [
    { keys: ['Space'], does: 'Shuffle' },
    { keys: ['L'], does: 'Shuffle layout' },
    { keys: ['S'], does: 'Shuffle style' },
    { keys: ['P'], does: 'Shuffle photos' },
    { keys: ['Ctrl', 'Z'], does: 'Undo' },
    { keys: ['Shift', 'Ctrl', 'Z'], does: 'Redo' },
    { keys: ['←', '↑', '→', '↓'], does: 'Move between panels' },
    { keys: ['Enter'], does: 'Move a panel’s photo with the arrows' },
    { keys: [',', '.'], does: 'Earlier or later frame of a video, with Shift by a second' },
    { keys: ['+', '−', '0'], does: 'Zoom a panel’s photo, reset it' },
    { keys: ['Shift', 'Enter'], does: 'Select a panel' },
    { keys: ['Alt', '↑', '↓'], does: 'Slant a cut of the layout' },
    { keys: ['Ctrl', 'S'], does: 'Download PNG' },
    { keys: ['?'], does: 'This list' },
  ],

  // What went wrong
  fileFailed: (/** @type {string} */ name, /** @type {string} */ why) => `${name}: ${why}`,
  /** Reasons in the page's words where it knows better than the core, by error code. @type {Record<string, string>} */
  reasons: {
    'worker-lost': 'reading it stopped the program twice, so it was left out.',
    'unreadable-file': 'the file was moved, changed or deleted since you chose it.',
  },
  noUsablePhoto: 'None of these files could be used. Choose JPEG, PNG, WebP, AVIF, GIF, BMP or TIFF photos, or a video.',
  noSamples: 'The sample album could not be loaded. Check the connection and try again.',
  noPhotosInUse: 'No photo is in use. Tick one in Photos to get a page.',
  panelFailed: (/** @type {string} */ why) => `A panel could not be drawn: ${why}`,
  exportFailed: (/** @type {string} */ why) => `The file could not be made: ${why}`,
  coreFailed: (/** @type {string} */ why) => `Inkpanel could not start: ${why}`,
  locked: { layout: 'The layout is locked.', style: 'The style is locked.', photos: 'The photos are locked.' },
};
