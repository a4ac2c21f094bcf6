/** The one place that runs importers of user files: whatever an importer throws becomes a message that names the file. */

import { codeOf, explain } from './explain.ts';
import type { Messages, Way } from './messages.ts';

type Reporter = Pick<Messages, 'fileFailed'>;
/**
 * `reasons`: sentences by error code that override the general ones; `text`: the message if only this file fails;
 * `way`: the action for the user.
 */
type How = { reasons?: Readonly<Record<string, string>>; text?: (why: string) => string; way?: Way };

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
  const why = explain(error, { reasons });
  // Some reasons name the file themselves.
  messages.fileFailed(name, why, { text: text?.(why) ?? (why.includes(name) ? why : undefined), way });
}
