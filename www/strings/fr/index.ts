/** The page in French, of the shape of the English. */

import { animaticStrings } from './animatic.ts';
import { boardStrings } from './board.ts';
import { boardsStrings } from './boards.ts';
import { bookStrings } from './book.ts';
import { brushStrings } from './brush.ts';
import { describingStrings } from './describing.ts';
import { designerStrings } from './designer.ts';
import { exportStrings } from './export.ts';
import { faultStrings } from './faults.ts';
import { fileStrings } from './files.ts';
import { helpStrings } from './help.ts';
import { imitationStrings } from './imitation.ts';
import { keyStrings } from './keys.ts';
import { motionStrings } from './motion.ts';
import { offlineStrings } from './offline.ts';
import { pageStrings } from './page.ts';
import { panelStrings } from './panels.ts';
import { photoStrings } from './photos.ts';
import { pngStrings } from './png.ts';
import { sideStrings } from './side.ts';
import { soundStrings } from './sounds.ts';
import { speechStrings } from './speech.ts';
import { startStrings } from './start.ts';
import { storageStrings } from './storage.ts';
import { wordStrings } from './words.ts';
import { printStrings } from './print.ts';
import type { Words } from '../en/index.ts';

export { names } from './names.ts';

export const words: Words = {
  ...startStrings,
  ...boardStrings,
  ...boardsStrings,
  ...animaticStrings,
  ...motionStrings,
  ...bookStrings,
  ...brushStrings,
  ...sideStrings,
  ...panelStrings,
  ...designerStrings,
  ...storageStrings,
  ...offlineStrings,
  ...soundStrings,
  ...speechStrings,
  ...wordStrings,
  ...photoStrings,
  ...pageStrings,
  ...exportStrings,
  ...fileStrings,
  ...printStrings,
  ...pngStrings,
  ...imitationStrings,
  ...keyStrings,
  ...helpStrings,
  ...faultStrings,
  ...describingStrings,
};
