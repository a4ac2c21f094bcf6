/** The core and the data files are in English. Only blocks have plainer names here. */

import { blocks } from './blocks.ts';
import type { Names } from '../names.ts';

export const names: Names = {
  families: {},
  choices: { luma: 'Luma', each: 'Each channel' },
  blocks,
  parameters: {},
  layouts: {},
  styles: {},
  verdicts: {
    same: (name) => `same as ${name}`,
    sharpest: (of) => `sharpest of ${of}`,
    only: 'only one like it',
    blurred: 'blurred',
  },
};
