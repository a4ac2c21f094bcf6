// @ts-check
/** JSON files from outside: a style has a layer of blocks, everything else is taken for a layout. */

import { LONGEST_STYLE } from './style-link.js';

/**
 * @param {readonly File[]} files
 * @param {{ ownLayouts: Pick<import('./own-layouts.js').OwnLayouts, 'open'>, ownStyles: Pick<import('./own-styles.js').OwnStyles, 'open'> }} to
 */
export async function openPlans(files, { ownLayouts, ownStyles }) {
  const kinds = await Promise.all(files.map(isStyle));
  await ownLayouts.open(files.filter((_, i) => !kinds[i]));
  await ownStyles.open(files.filter((_, i) => kinds[i]));
}

/** @param {File} file */
async function isStyle(file) {
  if (file.size > LONGEST_STYLE) return false;
  try {
    const value = JSON.parse(await file.text());
    return typeof value === 'object' && value !== null && ['background', 'foreground'].some((layer) => layer in value);
  } catch {
    return false;
  }
}
