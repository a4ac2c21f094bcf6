/** The one place that runs importers of user files: whatever an importer throws becomes a message that names the file. */

import { strings } from '../strings/strings.ts';
import type { Messages, Way } from './messages.ts';

type Reporter = Pick<Messages, 'fileFailed'>;
/**
 * `reasons`: sentences by error code that override the general ones; `text`: the message if only this file fails;
 * `way`: the action for the user.
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
  if (codeOf(error) === 'cancelled') return;
  const why = reasonOf(error, reasons);
  // Some reasons name the file themselves.
  messages.fileFailed(name, why, { text: text?.(why) ?? (why.includes(name) ? why : undefined), way });
}

/** @returns the code of an error of this program; empty for all others */
export function codeOf(error: unknown): string {
  const { code } = (error ?? {}) as { code?: unknown };
  return typeof code === 'string' ? code : '';
}

/** @returns why a file could not be read, as a sentence */
export function reasonOf(error: unknown, reasons: How['reasons'] = {}): string {
  const { name, message } = (error ?? {}) as { name?: unknown; message?: unknown };
  const code = codeOf(error);
  const text = typeof message === 'string' ? message : '';
  if (code !== '') return reasons[code] ?? strings.reasons[code] ?? strings.reasonsOf[code]?.(text) ?? text;
  if (UNREADABLE.includes(name)) return strings.reasons['unreadable-file'];
  // Importers throw sentences as plain errors. All other errors come from bugs.
  if (name === 'Error' && text !== '') return text;
  return strings.importBroken(text || (typeof error === 'string' ? error : Object.prototype.toString.call(error)));
}
