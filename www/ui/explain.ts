/** Explains errors to the user, in the language of the app. */

import { currentLanguage } from '../strings/language.ts';
import { strings } from '../strings/strings.ts';

/** Names of the errors of browsers for files that cannot be read. */
const UNREADABLE: readonly unknown[] = ['NotFoundError', 'NotReadableError', 'SecurityError'];

/** @returns the code of an error of this program; empty for all others */
export function codeOf(error: unknown): string {
  const { code } = (error ?? {}) as { code?: unknown };
  return typeof code === 'string' ? code : '';
}

/**
 * Returns the reason of a failure as a sentence. Messages of the core and of browsers are English, so other languages show the
 * code or the name of an error that they do not know.
 * @param how `reasons`: sentences by error code that override the general ones; `english`: whether English is shown
 */
export function explain(
  error: unknown,
  {
    reasons = {},
    english = currentLanguage() === 'en',
  }: { reasons?: Readonly<Record<string, string>>; english?: boolean } = {},
): string {
  const { name, message } = (error ?? {}) as { name?: unknown; message?: unknown };
  const code = codeOf(error);
  const text = typeof message === 'string' ? message : '';
  const known =
    reasons[code] ?? strings.reasons[code] ?? strings.projectReasons[code] ?? strings.reasonsOf[code]?.(text);
  if (code !== '') return known ?? (english && text !== '' ? text : strings.internalError(code));
  if (UNREADABLE.includes(name)) return strings.reasons['unreadable-file'];
  // The app throws its own sentences as plain errors. All other errors come from browsers or bugs.
  if (name === 'Error' && text !== '') return text;
  const fallback = typeof error === 'string' ? error : Object.prototype.toString.call(error);
  return strings.internalError((english && text) || (typeof name === 'string' && name) || fallback);
}
