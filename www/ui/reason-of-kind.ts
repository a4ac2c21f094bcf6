/** Sentences about kinds of files that are not photos. */

import { strings } from '../strings/strings.ts';
import type { FileKind } from '../engine/file-table.ts';

/** @returns why a file of this kind cannot be read, with the solution; empty for other kinds */
export function reasonOfKind({ name, role, remedy }: FileKind): string {
  if (role === 'board') return strings.boardFile;
  return remedy ? strings.unsupportedKind(name, strings.remedies[remedy]) : '';
}
