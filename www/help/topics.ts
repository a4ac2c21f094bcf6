/** The texts of the help, in the current language. They are loaded with the help. */

import * as english from '../strings/compiled/help-en.ts';
import { currentFormats, language } from '../strings/strings.ts';
import type { Messages } from '../strings/compiled/help-en.ts';
import type { Formats } from '../strings/formats.ts';
import type { Language } from '../strings/language.ts';

type Help = { messages: (formats: Formats) => Messages };

/** English is loaded in parallel with the dialog, because that is the most frequent case. */
const OTHERS: Record<Exclude<Language, 'en'>, () => Promise<Help>> = {
  de: () => import('../strings/compiled/help-de.ts'),
  es: () => import('../strings/compiled/help-es.ts'),
  fr: () => import('../strings/compiled/help-fr.ts'),
  ja: () => import('../strings/compiled/help-ja.ts'),
  pt: () => import('../strings/compiled/help-pt.ts'),
};

const { messages }: Help = language === 'en' ? english : await OTHERS[language]().catch(() => english);

export const topicMessages = messages(currentFormats);
