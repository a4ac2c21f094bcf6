// @ts-check
/** Every word of the page in English: the language that the others are checked against and fall back to. */

import { boardStrings } from './board.js';
import { bookStrings } from './book.js';
import { coreStrings } from './core.js';
import { describingStrings } from './describing.js';
import { designerStrings } from './designer.js';
import { exportStrings } from './export.js';
import { faultStrings } from './faults.js';
import { keepingStrings } from './keeping.js';
import { keyStrings } from './keys.js';
import { offlineStrings } from './offline.js';
import { pageStrings } from './page.js';
import { panelStrings } from './panels.js';
import { photoStrings } from './photos.js';
import { pngStrings } from './png.js';
import { sideStrings } from './side.js';
import { startStrings } from './start.js';
import { wordStrings } from './words.js';

export const english = {
  ...startStrings,
  ...boardStrings,
  ...bookStrings,
  ...sideStrings,
  ...panelStrings,
  ...designerStrings,
  ...keepingStrings,
  ...pngStrings,
  ...offlineStrings,
  ...wordStrings,
  ...photoStrings,
  ...pageStrings,
  ...exportStrings,
  ...keyStrings,
  ...faultStrings,
  ...coreStrings,
  ...describingStrings,
};

/** @typedef {typeof english} Strings */
