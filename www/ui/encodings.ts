/** Text files in a guessed encoding: the guess is reported, and the user can read the file in another encoding. */

import { signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { explain } from './explain.ts';
import type { Signal } from '@preact/signals';
import type { DecodedText } from '../engine/text-file.ts';
import type { Store } from '../document/store.ts';
import type { Messages } from './messages.ts';

/** `again` reads the file in another encoding. */
export type EncodingChoice = { file: File; encoding: string; again: (encoding: string) => void };

/** The result of an import. `amend` repeats it in another encoding after other edits, as one undo step. */
export type ImportedText = { decoded: DecodedText; amend: (encoding: string) => Promise<ImportedText> };

/** The name of an encoding in texts. */
export function encodingName(encoding: string): string {
  return encoding.replace(/^windows/, 'Windows');
}

/** The file whose encoding is being chosen. */
export const choosing: Signal<EncodingChoice | null> = signal(null);

/**
 * Runs an import of a text file, and reports the encoding if it was guessed. If the user chooses another encoding, the import
 * is undone and repeated. After other edits, it replaces the texts of the import that the user has not edited.
 * @param take imports the file
 */
export async function importText(
  file: File,
  { store, messages }: { store: Pick<Store, 'project' | 'change'>; messages: Pick<Messages, 'alert'> },
  take: (encoding: string) => Promise<ImportedText>,
  encoding = '',
) {
  const before = store.project.peek();
  const { decoded, amend } = await take(encoding);
  if (!decoded.guessed && decoded.lost === 0 && encoding === '') return;
  const after = store.project.peek();
  const again = (other: string) => {
    const isLast = store.project.peek() === after;
    if (isLast && after !== before) store.change({ type: 'undo' });
    const how = isLast || after === before ? take : amend;
    void importText(file, { store, messages }, how, other).catch((error) => messages.alert(explain(error)));
  };
  const says = [
    strings.textGuessed({ encoding: encodingName(decoded.encoding) }),
    ...(decoded.lost > 0 ? [strings.textLost({ n: decoded.lost })] : []),
  ].join(' ');
  messages.alert(strings.fileFailed({ name: file.name, why: says }), {
    label: strings.changeEncoding,
    run: () => {
      choosing.value = { file, encoding: decoded.encoding, again };
    },
  });
}
