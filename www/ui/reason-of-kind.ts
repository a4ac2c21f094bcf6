/** Sentences about kinds of files that are not photos. */

import { strings } from '../strings/strings.ts';
import type { FileKind } from '../engine/file-table.ts';

/** @returns advice for a file of this kind; empty without advice */
export function reasonOfKind({ name, role, remedy }: FileKind): string {
  if (role === 'board') return strings.boardFile;
  return remedy ? strings.unsupportedKind({ name, remedy: strings.remedies[remedy] }) : '';
}
