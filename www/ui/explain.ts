/** Explains errors to the user, in the language of the app. */

import { currentLanguage } from '../strings/language.ts';
import { textAt } from '../strings/compose.ts';
import { UserError } from './user-error.ts';
import { strings } from '../strings/strings.ts';

/** Names of the errors of browsers for files that cannot be read. */
const UNREADABLE: readonly unknown[] = ['NotFoundError', 'NotReadableError', 'SecurityError'];

/** Whether the reason of this code names what the message of the error names. */
const isNaming = (code: string): code is keyof typeof strings.reasonsOf => Object.hasOwn(strings.reasonsOf, code);

/** @returns the code of an error of this program; empty for all others */
export function codeOf(error: unknown): string {
  const { code } = (error ?? {}) as { code?: unknown };
  return typeof code === 'string' ? code : '';
}

/** Returns the technical detail of an error, for reports: its message in English, otherwise its code or name. */
export function detailOf(error: unknown, english = currentLanguage() === 'en'): string {
  const { name, message } = (error ?? {}) as { name?: unknown; message?: unknown };
  const detail = english ? message : codeOf(error) || name;
  return typeof detail === 'string' ? detail : '';
}

/**
 * Returns the reason of a failure as a sentence. Messages of the core and of browsers are English, so other languages show a general
 * sentence, or the code or the name of an unknown error.
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
  if (code !== '') {
    const known = [reasons, strings.reasons, strings.projectReasons].map((texts) => textAt(texts, code)).find(Boolean);
    if (known) return known;
    if (isNaming(code)) return strings.reasonsOf[code]({ what: text });
    return (english && text) || (strings.coreReason(code) ?? strings.internalError({ what: code }));
  }
  if (UNREADABLE.includes(name)) return strings.reasons['unreadable-file'];
  // Modules and libraries throw English sentences.
  if (text !== '' && (error instanceof UserError || (english && name === 'Error'))) return text;
  const fallback = typeof error === 'string' ? error : Object.prototype.toString.call(error);
  return strings.internalError({ what: (english && text) || (typeof name === 'string' && name) || fallback });
}
