/** The one place that runs importers of user files: whatever an importer throws becomes a message that names the file. */

import { strings } from '../strings/strings.ts';
import type { Messages, Way } from './messages.ts';

type Reporter = Pick<Messages, 'fileFailed'>;
/**
 * `reasons`: sentences by error code, which are used before the general ones; `text`: the message if only this file
 * fails; `way`: what the user can do about it.
 */
type How = { reasons?: Readonly<Record<string, string>>; text?: (why: string) => string; way?: Way };

/** Names of the errors of browsers for files that cannot be read. */
const UNREADABLE: readonly unknown[] = ['NotFoundError', 'NotReadableError', 'SecurityError'];

/**
 * Runs an importer.
 * @param name of the file, for the message
 * @returns undefined if the importer failed, which was reported, or was cancelled
 */
export async function importing<T>(
  messages: Reporter,
  name: string,
  read: () => T | Promise<T>,
  how: How = {},
): Promise<T | undefined> {
  try {
    return await read();
  } catch (error) {
    reportFailure(messages, name, error, how);
    return undefined;
  }
}

/** Reports that a file could not be read. Cancelled work is not reported. */
export function reportFailure(messages: Reporter, name: string, error: unknown, { reasons, text, way }: How = {}) {
  if ((error as { code?: unknown } | null | undefined)?.code === 'cancelled') return;
  const why = reasonOf(error, reasons);
  // Some reasons name the file themselves.
  messages.fileFailed(name, why, { text: text?.(why) ?? (why.includes(name) ? why : undefined), way });
}

/** @returns why a file could not be read, as a sentence */
export function reasonOf(error: unknown, reasons: How['reasons'] = {}): string {
  const { code, name, message } = (error ?? {}) as { code?: unknown; name?: unknown; message?: unknown };
  const text = typeof message === 'string' ? message : '';
  if (typeof code === 'string')
    return reasons[code] ?? strings.reasons[code] ?? strings.reasonsOf[code]?.(text) ?? text;
  if (UNREADABLE.includes(name)) return strings.reasons['unreadable-file'];
  // Importers throw sentences as plain errors. All other errors come from bugs.
  if (name === 'Error' && text !== '') return text;
  return strings.importBroken(text || (typeof error === 'string' ? error : Object.prototype.toString.call(error)));
}
