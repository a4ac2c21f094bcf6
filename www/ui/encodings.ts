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

/** The name of an encoding in texts. */
export function encodingName(encoding: string): string {
  return encoding.replace(/^windows/, 'Windows');
}

/** The file whose encoding is being chosen. */
export const choosing: Signal<EncodingChoice | null> = signal(null);

/**
 * Runs an import of a text file, and reports the encoding if it was guessed. If the user chooses another encoding, the import
 * is undone and repeated.
 * @param take imports the file, and returns how it was decoded
 */
export async function importText(
  file: File,
  { store, messages }: { store: Pick<Store, 'project' | 'change'>; messages: Pick<Messages, 'alert'> },
  take: (encoding: string) => Promise<DecodedText>,
  encoding = '',
) {
  const before = store.project.peek();
  const decoded = await take(encoding);
  if (!decoded.guessed && decoded.lost === 0 && encoding === '') return;
  const after = store.project.peek();
  const again = (other: string) => {
    // After another edit, the import is no longer the last step.
    if (store.project.peek() === after && after !== before) store.change({ type: 'undo' });
    void importText(file, { store, messages }, take, other).catch((error) => messages.alert(explain(error)));
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
