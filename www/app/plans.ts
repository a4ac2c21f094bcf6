/** JSON files from outside: a style has a layer of blocks, everything else is taken for a layout. */

import { LONGEST_STYLE } from '../styles/style-link.ts';
import type { OwnLayouts } from '../layouts/own-layouts.ts';
import type { OwnStyles } from '../styles/own-styles.ts';

export async function openPlans(
  files: readonly File[],
  { ownLayouts, ownStyles }: { ownLayouts: Pick<OwnLayouts, 'open'>; ownStyles: Pick<OwnStyles, 'open'> },
) {
  const kinds = await Promise.all(files.map(isStyle));
  await ownLayouts.open(files.filter((_, i) => !kinds[i]));
  await ownStyles.open(files.filter((_, i) => kinds[i]));
}

async function isStyle(file: File) {
  if (file.size > LONGEST_STYLE) return false;
  try {
    const value = JSON.parse(await file.text());
    return typeof value === 'object' && value !== null && ['background', 'foreground'].some((layer) => layer in value);
  } catch {
    return false;
  }
}
