/** JSON files of users: a style has a layer of blocks, a layout has panels. */

import { readText } from '../engine/text-file.ts';
import { LONGEST_STYLE } from '../styles/style-link.ts';
import { strings } from '../strings/strings.ts';
import type { OwnLayouts } from '../layouts/own-layouts.ts';
import type { OwnStyles } from '../styles/own-styles.ts';
import type { Messages } from '../ui/messages.ts';

type Kind = 'style' | 'layout' | 'other';

/** A file of this kind has at least one of these fields. */
const FIELDS = { style: ['background', 'foreground'], layout: ['family', 'tree', 'polygons'] } as const;

/**
 * @param beside whether photos were opened with the files: then JSON of other programs, such as Google Takeout, is
 * skipped
 */
export async function openPlans(
  files: readonly File[],
  {
    ownLayouts,
    ownStyles,
    messages,
    beside,
  }: {
    ownLayouts: Pick<OwnLayouts, 'open'>;
    ownStyles: Pick<OwnStyles, 'open'>;
    messages: Pick<Messages, 'fileFailed'>;
    beside: boolean;
  },
) {
  const kinds = await Promise.all(files.map(kindOf));
  const of = (kind: Kind) => files.filter((_, i) => kinds[i] === kind);
  await ownLayouts.open(of('layout'));
  await ownStyles.open(of('style'));
  if (!beside) for (const { name } of of('other')) messages.fileFailed(name, strings.unknownJson);
}

/** A file that is not JSON counts as a layout, because the layout reader reports the error. */
async function kindOf(file: File): Promise<Kind> {
  if (file.size > LONGEST_STYLE) return 'other';
  try {
    const value = JSON.parse((await readText(file)).text);
    const has = (kind: 'style' | 'layout') =>
      typeof value === 'object' && value !== null && FIELDS[kind].some((field) => Object.hasOwn(value, field));
    return has('style') ? 'style' : has('layout') ? 'layout' : 'other';
  } catch {
    return 'layout';
  }
}
